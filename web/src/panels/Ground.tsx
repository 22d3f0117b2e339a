// Results of the laid pipe: on an uneven seabed, and along its route.
import type { LaidPipeState, RouteSummary } from '../api/types';
import { numberIn, text, unitName } from '../logic/show';
import { Value } from './StingerSections';

const many = 8; // maximum number of spans listed individually

export function LaidPipe({ bed }: { bed: LaidPipeState }) {
  const spans = [...bed.free_spans].sort((a, b) => b.length - a.length);
  return (
    <section class="ground" aria-label="Laid pipe">
      <h3>Laid pipe</h3>
      <dl>
        <Value name="hogging moment" value={bed.hogging_moment} unit="N m" result="static.seabed.max_hogging_moment.value" title={`${text(bed.hogging_x, 'm')} astern of the stern shoe.`} />
        <Value name="sagging moment" value={bed.sagging_moment} unit="N m" result="static.seabed.max_sagging_moment.value" title={`${text(bed.sagging_x, 'm')} astern of the stern shoe.`} />
        <Value name="bending stress" value={bed.bending_stress} unit="Pa" />
        <Value name="tension at the anchored end" value={bed.tail_tension} unit="N" result="static.seabed.tail_tension" />
      </dl>
      {spans.length > 0 ? (
        <table class="minmax spans">
          <caption>{spans.length === 1 ? 'One free span' : `${spans.length} free spans${spans.length > many ? `, the longest ${many}` : ''}`}</caption>
          <thead><tr>{['from', 'to', 'length', 'gap'].map((head) => <th key={head} scope="col">{head}, {unitName('m')}</th>)}<th scope="col">stress, {unitName('Pa')}</th></tr></thead>
          <tbody>
            {spans.slice(0, many).map((span) => (
              <tr key={span.x_from}><td>{numberIn(span.x_from, 'm')}</td><td>{numberIn(span.x_to, 'm')}</td><td>{numberIn(span.length, 'm', 3)}</td><td>{numberIn(span.largest_gap, 'm', 3)}</td><td>{numberIn(span.bending_stress, 'Pa', 3)}</td></tr>
            ))}
          </tbody>
        </table>
      ) : null}
    </section>
  );
}

const side = (v: number): string => (v < 0 ? 'to starboard' : 'to port');
const noLoad = 1; // [N]

/** A straight route without a side load has no results. */
export function Route({ route }: { route: RouteSummary }) {
  const loaded = Math.max(Math.abs(route.side_load_bed), Math.abs(route.side_load_supports)) > noLoad;
  if (!loaded && !(route.radius > 0)) return null;
  return (
    <section class="ground" aria-label="Lay route">
      <h3>Lay route</h3>
      <dl>
        {loaded ? (
          <>
            <Value name={`touchdown ${side(route.laid_offset)}`} value={Math.abs(route.laid_offset)} unit="m" title="Relative to the route." />
            <Value name={`supports ${side(route.side_load_supports)}`} value={Math.abs(route.side_load_supports)} unit="N" title="Side load on rollers and tensioner." />
            <Value name={`seabed ${side(route.side_load_bed)}`} value={Math.abs(route.side_load_bed)} unit="N" title="Side load on the seabed." />
          </>
        ) : null}
        {route.radius > 0 ? (
          <>
            <Value name="radius of the route" value={route.radius} unit="m" />
            <Value name="minimum radius" value={route.least_radius > 0 ? route.least_radius : null} unit="m" title="Minimum radius that lateral friction can hold at this bottom tension." />
            <Value name="lateral slip" value={route.slid_length} unit="m" title={`Maximum ${text(Math.abs(route.largest_offset), 'm', 3)} ${side(route.largest_offset)} of the route.`} />
          </>
        ) : null}
      </dl>
    </section>
  );
}
