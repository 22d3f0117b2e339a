// Parts of a workspace of the page; the frame (panels/App.tsx) places them.
import type { ComponentType } from 'preact';
import type { ReadonlySignal } from '@preact/signals';

export type WorkspaceId = 'lay' | 'operation' | 'storm' | 'study' | 'runs' | 'report';

export interface DockTab {
  id: string;
  title: string;
  /** True if the open model or its results have content for this part; always if omitted. */
  shown?: () => boolean;
  View: ComponentType;
}

export interface WorkspaceParts {
  id: WorkspaceId;
  title: string;
  /** Settings and commands above the picture. */
  Strip?: ComponentType;
  /** Replaces the picture. */
  Middle?: ComponentType;
  /** True if the picture is shown next to the workspace's own middle; never if omitted. */
  picture?: ReadonlySignal<boolean>;
  /** Under the picture: sliders, playback. */
  Bar?: ComponentType;
  /** Below; without any the middle uses the whole height. */
  tabs: DockTab[];
}
