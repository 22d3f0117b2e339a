// Legend of the picture: quantity along the pipe, its scale and limit, and loads of the rollers.
import { gradientCss } from '../../components/colourScale';
import { loadCss } from '../../logic/colour';
import { partColours } from '../../logic/operation';
import { quantities, text } from '../../logic/show';
import { tidy } from '../../logic/units';
import { largestReaction, shown as frame } from '../../state/animation';
import { colourBy, theme, type ColourBy } from '../../state/look';
import { calmLay, ofRun, shownStage } from '../../state/shown';
import { animating, flashing } from './moment';
import { pipeColours, inFrames, type Colours } from './colouring';

function Choice({ value, animated }: { value: ColourBy; animated: boolean }) {
  const closed = (key: string): boolean => animated && !inFrames(key as ColourBy);
  return (
    <select
      aria-label="Colour of the pipe"
      title={animated ? 'Animations contain tension and von Mises stress only; other quantities are in the diagrams.' : undefined}
      value={value}
      onChange={(e) => { colourBy.value = e.currentTarget.value as ColourBy; }}
    >
      {quantities.filter((x) => x.key !== 'bending_moment').map((x) => (
        <option key={x.key} value={x.key} disabled={closed(x.key)}>{x.name}{closed(x.key) ? ' (not in animations)' : ''}</option>
      ))}
    </select>
  );
}

/** Numbers below the scale: its ends, and the limit if values exceed it. */
function Ends({ colours: { scale, shown, limit } }: { colours: Colours }) {
  const unit = shown.unit === '–' ? '' : ` ${shown.unit}`;
  const over = scale.high > scale.top, part = (scale.top - scale.low) / (scale.high - scale.low || 1);
  return (
    <>
      <div class="ends">
        <span>{tidy(scale.low, 3)}</span>
        {over && part > 0.22 && part < 0.8 ? <span class="limitend" style={{ left: `${100 * part}%` }}>{tidy(scale.top, 3)}</span> : null}
        <span>{tidy(scale.high, 3)}{unit}</span>
      </div>
      {limit && (over || scale.top === limit.value) ? (
        <div class={`limitkey${over ? ' over' : ''}`}>{over ? <><i /> above {limit.name}, {tidy(limit.value, 3)}{unit}</> : `limit: ${limit.name}`}</div>
      ) : null}
    </>
  );
}

function LoadKey({ animated }: { animated: boolean }) {
  const supports = calmLay.value?.supports ?? [];
  if (supports.length === 0) return null;
  const largest = animated ? largestReaction.value : Math.max(0, ...supports.flatMap((x) => x.rollers.map((r) => r.reaction)));
  if (animated && !largest) return <div class="rollerkey">no reactions in this run</div>;
  return (
    <div class="rollerkey">
      <i class="solid" style={{ background: loadCss }} /> {animated ? 'box' : 'roller'}{largest ? `, to ${text(largest, 'N', 3)}` : ' carries'}
      <span><i class={animated ? 'pale' : 'hollow'} /> clear</span>
    </div>
  );
}

function PartKey() {
  if (ofRun.value || !shownStage.value?.parts) return null;
  const { head, cable } = partColours(theme.value === 'dark');
  return <div class="rollerkey"><i style={{ background: head }} /> head <span><i style={{ background: cable }} /> cable</span></div>;
}

export function Legend() {
  const animated = animating.value, lay = calmLay.value;
  const colours = pipeColours(lay, animated && frame.peek() !== null);
  return (
    <div class="legend" data-clear data-flashes={animated ? flashing.value : undefined}>
      <Choice value={colours.key} animated={animated} />
      <div class="ramp" style={{ background: gradientCss(colours.scale) }} />
      <Ends colours={colours} />
      <LoadKey animated={animated} />
      <PartKey />
    </div>
  );
}
