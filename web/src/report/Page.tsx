// The whole page of a report.
import { useMemo } from 'preact/hooks';
import { Blocks, FigureContext, type FigureBlock } from '../components/Block';
import type { ReportDocument, ShownUnits } from '../components/document';
import { FrontPage } from '../components/FrontPage';
import { figureNumbers } from '../components/outline';
import { unitsFromTable, UnitsContext } from '../components/units';
import { Figure } from './figures';
import { PageMargins } from './PageMargins';

interface Props {
  report: ReportDocument;
  /** Data of the figures. */
  data: unknown;
  units: ShownUnits;
}

export function Page({ report, data, units }: Props) {
  const shown = useMemo(() => unitsFromTable(units), [units]);
  const NumberedFigure = useMemo(() => {
    const numbers = figureNumbers(report.body);
    return ({ figure }: { figure: FigureBlock }) => <Figure figure={figure} number={numbers.get(figure) ?? 0} data={data} />;
  }, [report, data]);
  return (
    <UnitsContext.Provider value={shown}>
      <FigureContext.Provider value={NumberedFigure}>
        <PageMargins report={report} />
        <main>
          <FrontPage front={report.front} body={report.body} />
          <div class="sections">
            <Blocks blocks={report.body} />
          </div>
        </main>
      </FigureContext.Provider>
    </UnitsContext.Provider>
  );
}
