// Curves of several result folders in one chart.
import { Chart } from '../../components/Chart';
import { curveColours, curveDashes } from '../../components/colours';
import { nameEnd, roomAround, wholeRange } from '../../components/keyAxis';
import type { OverlayData } from '../data';
import type { DrawFigure } from '../figures';

/** Every folder has a different dash, so that they can be distinguished in grey print. */
const folderLook = (folder: number) => ({ colour: curveColours[folder % curveColours.length]!, dash: curveDashes[folder % curveDashes.length] });

function Overlay({ names, figures }: OverlayData) {
  const legend = names.map((name, folder) => ({ text: nameEnd(name, 24), ...folderLook(folder) }));
  return (
    <>
      {figures.filter(({ curves }) => curves.some(({ points }) => points.length > 0)).map(({ title, x_label, y_label, curves }) => {
        const points = curves.flatMap((curve) => curve.points);
        return (
          <Chart
            small title={title} height={250} x={{ range: wholeRange(points.map(([x]) => x)), label: x_label }}
            y={{ range: roomAround(points.map(([, y]) => y), 0.06), label: y_label }} legend={legend}
            curves={curves.map((curve) => ({ points: curve.points, width: 1.8, title: names[curve.folder], ...folderLook(curve.folder) }))}
          />
        );
      })}
    </>
  );
}

export const overlayFigures: Record<string, DrawFigure> = {
  overlay: ({ data }) => <Overlay {...(data as { overlay: OverlayData }).overlay} />,
};
