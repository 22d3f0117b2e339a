// Ramp and stinger seen from port, true to scale.
import type { VNode } from 'preact';
import type { LayData } from '../../components/lay';
import { SideView, rollerLooks } from '../../components/SideView';
import { useUnits } from '../../components/units';
import type { FigureProps } from '../figures';

const legend = [
  { text: 'roller in contact', colour: rollerLooks.contact, look: 'block' as const },
  { text: 'without contact', colour: rollerLooks.noContact, look: 'block' as const },
];

export function StingerView({ part, data }: FigureProps): VNode | null {
  const units = useUnits();
  const lay = data as LayData;
  const stinger = lay.supports.filter((box) => box.stinger);
  const last = lay.supports.at(-1)!;
  if (part === 'tip') {
    const values = `the reaction [${units.unit('N').name}] or, without contact, the separation [${units.unit('section').name}]`;
    const room = { before: 1.5, after: 3, below: 2.2, above: 1.6 };
    return <SideView lay={lay} title={`Last box, ${last.name}: at bottom rollers ${values}`} boxes={[last]} room={room} maxHeight={330} detail={last} />;
  }
  if (part === 'overbend') {
    const room = { before: 3, after: 4, below: 3, above: 8 };
    return <SideView lay={lay} title="Ramp and stinger" boxes={lay.supports} room={room} maxHeight={420} legend={legend} />;
  }
  if (stinger.length === 0) return null;
  const room = { before: 2, after: 4, below: 3, above: 6 };
  return <SideView lay={lay} title="Stinger" boxes={stinger} room={room} maxHeight={420} legend={legend} />;
}
