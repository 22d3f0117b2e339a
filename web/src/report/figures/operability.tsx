// Operability: the limit over a key, by direction, and the workable time by month.
import { OperabilityChart, OperabilityRose, Workability, type OperabilityData } from '../../components/Operability';
import type { StudyData } from '../data';
import type { DrawFigure } from '../figures';

const readLimits = (data: unknown): OperabilityData => (data as { study: StudyData }).study.operability!;

export const operabilityFigures: Record<string, DrawFigure> = {
  operability_chart: ({ data }) => <OperabilityChart all={readLimits(data)} />,
  operability_rose: ({ data }) => <OperabilityRose all={readLimits(data)} />,
  workability: ({ data }) => <Workability months={readLimits(data).months ?? []} year={readLimits(data).year ?? 0} />,
};
