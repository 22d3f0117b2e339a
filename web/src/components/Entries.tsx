// Names with values.

/** An empty value keeps the height of a line, for handwriting. */
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
