// The configuration in three dimensions.
import { useCallback } from 'preact/hooks';
import type { LayData } from '../../components/lay';
import { wholeEnd } from '../../components/lay';
import { boxesScene, largestOfScale, rollerColours, wholeScene, yields, type SceneContent } from '../../components/layScene';
import type { Camera } from '../../components/painter';
import { ColourKey, Scene } from '../../components/Scene';
import { useUnits } from '../../components/units';
import type { FigureProps } from '../figures';

const degrees = Math.PI / 180;

interface View { title: string; azimuth: number; elevation: number; height: number; build: (lay: LayData, camera: Camera) => SceneContent }

function findView(lay: LayData, part: string): View | null {
  if (part === 'whole') {
    const steep = lay.water_depth > 0.4 * wholeEnd(lay);
    return { title: 'Whole line', azimuth: steep ? -62 : -70, elevation: 20, height: steep ? 520 : 385, build: wholeScene };
  }
  if (part === 'overbend') {
    const build = (data: LayData, camera: Camera): SceneContent => boxesScene(data, camera, data.supports, 8, 10);
    return { title: 'Overbend, with every roller (frames are schematic)', azimuth: -62, elevation: 20, height: 390, build };
  }
  const stinger = lay.supports.filter((box) => box.stinger);
  if (stinger.length === 0) return null;
  const build = (data: LayData, camera: Camera): SceneContent => boxesScene(data, camera, stinger, 2, 6);
  return { title: 'Stinger (frames are schematic)', azimuth: -62, elevation: 9, height: 405, build };
}

const rollerEntries = [
  { colour: rollerColours.contact, text: 'roller in contact' },
  { colour: rollerColours.noContact, text: 'roller without contact' },
];

export function Configuration({ part, data }: FigureProps) {
  const lay = data as LayData;
  const { name, factor } = useUnits().unit('Pa');
  const view = findView(lay, part);
  const build = useCallback((camera: Camera) => view!.build(lay, camera), [lay, part]);
  if (!view) return null;
  return (
    <Scene title={view.title} height={view.height} azimuth={view.azimuth * degrees} elevation={view.elevation * degrees} build={build}>
      <ColourKey
        title={`von Mises stress in the pipe [${name}]`}
        top={largestOfScale(lay) * factor}
        beyond={yields(lay) ? 'above the yield stress' : null}
        entries={lay.supports.length > 0 ? rollerEntries : []}
      />
    </Scene>
  );
}
