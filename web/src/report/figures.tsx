// Figures of a report: the component for each figure id.
import { Component, type ComponentChildren, type VNode } from 'preact';
import type { FigureBlock } from '../components/Block';
import { Reactions, Separations } from './figures/boxes';
import { ComparedContactChart } from './figures/comparedContact';
import { ComparedTensionerChart } from './figures/comparedTensioner';
import { Configuration } from './figures/configuration';
import { Impacts, Ranges, Shares } from './figures/contacts';
import { Curves } from './figures/curves';
import { Diagram, Envelope } from './figures/diagrams';
import { Geometry } from './figures/geometry';
import { History, Spectra } from './figures/histories';
import { LineShape, LineTension } from './figures/lines';
import { MooringOffsets, MooringPlan, MooringProfile } from './figures/moorings';
import { MooringStages, MovePipe } from './figures/mooringStages';
import { StageCurves } from './figures/stageCurves';
import { Stages } from './figures/stages';
import { StingerView } from './figures/stinger';
import { layTableFigures } from './figures/lay_table';
import { operabilityFigures } from './figures/operability';
import { overlayFigures } from './figures/overlay';
import { seekFigures } from './figures/seek';
import { studyFigures } from './figures/study';
import { Tornado } from './figures/tornado';
import { Checks, Fatigue } from './figures/utilisation';

export interface FigureProps {
  id: string;
  part: string;
  /** Data of the block, otherwise of the whole page. */
  data: unknown;
  /** Its drawings are set in two columns. */
  small: boolean;
}

export type DrawFigure = (props: FigureProps) => VNode | null;

/** By id, in alphabetical order; modules with several figures have tables below. */
const figures: Record<string, DrawFigure> = {
  checks: Checks,
  compared_contact: ComparedContactChart,
  compared_tensioner: ComparedTensionerChart,
  configuration: Configuration,
  curves: Curves,
  diagram: Diagram,
  envelope: Envelope,
  fatigue: Fatigue,
  geometry: Geometry,
  history: History,
  impacts: Impacts,
  line_shape: LineShape,
  line_tension: LineTension,
  mooring_offsets: MooringOffsets,
  mooring_plan: MooringPlan,
  mooring_profile: MooringProfile,
  mooring_stages: MooringStages,
  move_pipe: MovePipe,
  ranges: Ranges,
  reactions: Reactions,
  separations: Separations,
  shares: Shares,
  spectra: Spectra,
  stage_curves: StageCurves,
  stages: Stages,
  stinger: StingerView,
  tornado: Tornado,
  ...layTableFigures,
  ...operabilityFigures,
  ...overlayFigures,
  ...seekFigures,
  ...studyFigures,
};

/** Curves of a quantity along the line have separate ids: "envelope_tension", "moment". */
function findFigure(id: string): DrawFigure | undefined {
  return figures[id] ?? (id.startsWith('envelope_') ? figures['envelope'] : figures['diagram']);
}

/** A figure that fails does not affect the rest of the page, and reports its error. */
class Guard extends Component<{ children: ComponentChildren }, { error: string }> {
  constructor(props: { children: ComponentChildren }) {
    super(props);
    this.state = { error: '' };
  }

  componentDidCatch(error: unknown): void {
    console.error(error);
    this.setState({ error: String(error) });
  }

  render() {
    if (this.state.error) return <p class="small">This figure could not be drawn: {this.state.error}</p>;
    return this.props.children;
  }
}

function Panel(props: FigureProps) {
  const Drawing = findFigure(props.id);
  if (!Drawing) throw new Error(`no figure "${props.id}"`);
  return <Drawing {...props} />;
}

/** Panels below one another with a caption: "Figure 3. Effective tension". */
export function Figure({ figure, number, data }: { figure: FigureBlock; number: number; data: unknown }) {
  const look = figure.small ? 'panel multiples' : 'panel';
  return (
    <figure>
      {figure.parts.map((part) => (
        <div class={look} data-figure={figure.id} data-part={part}>
          <Guard><Panel id={figure.id} part={part} data={figure.data ?? data} small={!!figure.small} /></Guard>
        </div>
      ))}
      <figcaption>Figure {number}. {figure.caption}</figcaption>
    </figure>
  );
}
