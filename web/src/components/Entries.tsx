// Names with values.

/** A value that is empty keeps the height of a line, to be written in by hand. */
export function Entries({ entries, framed = false }: { entries: [string, string][]; framed?: boolean }) {
  return (
    <dl class={framed ? 'control' : undefined}>
      {entries.map(([name, value]) => (
        <div>
          <dt>{name}</dt>
          <dd>{value || '\u00a0'}</dd>
        </div>
      ))}
    </dl>
  );
}
