// A field of a strip with a small label above it.
import type { ComponentChildren } from 'preact';

export function StripField({ id, label, title, children }: { id: string; label: string; title?: string; children: ComponentChildren }) {
  return (
    <div class="stripfield" title={title}>
      <label for={id}>{label}</label>
      {children}
    </div>
  );
}
