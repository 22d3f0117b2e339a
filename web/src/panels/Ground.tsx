// The laid pipe: how it lies on an uneven bed, and on its route.
import type { LaidPipeState, RouteSummary } from '../api/types';
import { numberIn, text, unitName } from '../logic/show';
import { Value } from './StingerSections';

const many = 8; // spans shown one by one

export function LaidPipe({ bed }: { bed: LaidPipeState }) {
  const spans = [...bed.free_spans].sort((a, b) => b.length - a.length);
  return (
    <section class="ground" aria-label="Laid pipe">
      <h3>Laid pipe</h3>
      <dl>
        <Value name="hogging moment" value={bed.hogging_moment} unit="N m" result="static.seabed.max_hogging_moment.value" title={`${text(bed.hogging_x, 'm')} astern of the stern shoe.`} />
        <Value name="sagging moment" value={bed.sagging_moment} unit="N m" result="static.seabed.max_sagging_moment.value" title={`${text(bed.sagging_x, 'm')} astern of the stern shoe.`} />
        <Value name="bending stress" value={bed.bending_stress} unit="Pa" />
        <Value name="tension at the far end" value={bed.tail_tension} unit="N" result="static.seabed.tail_tension" />
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

/** Of a straight route without a side load there is nothing to tell. */
export function Route({ route }: { route: RouteSummary }) {
  const loaded = Math.max(Math.abs(route.side_load_bed), Math.abs(route.side_load_supports)) > noLoad;
  if (!loaded && !(route.radius > 0)) return null;
  return (
    <section class="ground" aria-label="Lay route">
      <h3>Lay route</h3>
      <dl>
        {loaded ? (
          <>
            <Value name={`touchdown ${side(route.laid_offset)}`} value={Math.abs(route.laid_offset)} unit="m" title="Of the route." />
            <Value name={`supports ${side(route.side_load_supports)}`} value={Math.abs(route.side_load_supports)} unit="N" title="Side load on rollers and tensioner." />
            <Value name={`seabed ${side(route.side_load_bed)}`} value={Math.abs(route.side_load_bed)} unit="N" title="Side load on the seabed." />
          </>
        ) : null}
        {route.radius > 0 ? (
          <>
            <Value name="radius of the route" value={route.radius} unit="m" />
            <Value name="friction holds" value={route.least_radius > 0 ? route.least_radius : null} unit="m" title="Least radius that bottom tension and lateral friction hold." />
            <Value name="slid sideways" value={route.slid_length} unit="m" title={`At most ${text(Math.abs(route.largest_offset), 'm', 3)} ${side(route.largest_offset)} of the route.`} />
          </>
        ) : null}
      </dl>
    </section>
  );
}
