// Fatigue of welds in the selected run: allowable standby time, and damage during the passage.
import type { FatigueSpot } from '../api/types';
import { waitText } from '../logic/fatigue';
import { tidy } from '../logic/units';
import { runSummary } from '../state/runs';

function Row({ spot }: { spot: FatigueSpot }) {
  const where = `Largest damage rate ${(3600 * spot.worst_rate).toExponential(2)} per hour; curve ${spot.curve}, stress factor ${tidy(spot.stress_factor, 4)}`;
  return <tr title={where}><th scope="row">{spot.name} <small>{spot.curve}</small></th><td>{waitText(spot.standby)}</td><td>{spot.path_damage.toPrecision(2)}</td></tr>;
}

export function FatigueResults() {
  const fatigue = runSummary.value?.dynamic?.fatigue;
  if (!fatigue) return null;
  return (
    <table class="minmax" aria-label="Fatigue of welds">
      <thead><tr><th scope="col">fatigue</th><th scope="col" title="Time in this sea state until the fatigue budget of a weld is used up">standby</th><th scope="col" title="Fatigue damage of a weld from the tensioner to the seabed">during passage</th></tr></thead>
      <tbody>{fatigue.spots.map((spot) => <Row key={spot.name} spot={spot} />)}</tbody>
    </table>
  );
}
