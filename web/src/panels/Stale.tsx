// Reports that the results of the selected run are outdated.
import { staleKeys } from '../state/storm';
import '../styles/storm.css';

export function Stale({ brief }: { brief?: boolean }) {
  if (!staleKeys.value) return null;
  const text = brief ? 'of an earlier model' : `of an earlier model, changed since: ${staleKeys.value}`;
  return <span class="stalebadge" title={`The model has changed since this run: ${staleKeys.value}`}>{text}</span>;
}
