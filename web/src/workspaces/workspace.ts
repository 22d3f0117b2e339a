// What a workspace of the page is made of; the frame (panels/App.tsx) places the parts.
import type { ComponentType } from 'preact';
import type { ReadonlySignal } from '@preact/signals';

export type WorkspaceId = 'lay' | 'operation' | 'storm' | 'study' | 'runs' | 'report';

export interface DockTab {
  id: string;
  title: string;
  /** Whether the open model, or what is shown of it, has any of this; always without. */
  shown?: () => boolean;
  View: ComponentType;
}

export interface WorkspaceParts {
  id: WorkspaceId;
  title: string;
  /** Settings and commands above the picture. */
  Strip?: ComponentType;
  /** Takes the place of the picture. */
  Middle?: ComponentType;
  /** Whether the picture stands beside the workspace's own middle; without it never. */
  picture?: ReadonlySignal<boolean>;
  /** Under the picture: sliders, play-back. */
  Bar?: ComponentType;
  /** Below; without any the middle has the whole height. */
  tabs: DockTab[];
}
