// The YAML editor. Loaded only when it is first shown.
import { autocompletion, completionKeymap, closeBrackets, closeBracketsKeymap, type Completion, type CompletionContext, type CompletionResult } from '@codemirror/autocomplete';
import { defaultKeymap, indentWithTab } from '@codemirror/commands';
import { yaml } from '@codemirror/lang-yaml';
import { bracketMatching, HighlightStyle, indentOnInput, syntaxHighlighting } from '@codemirror/language';
import { lintGutter, setDiagnostics } from '@codemirror/lint';
import { highlightSelectionMatches, openSearchPanel, search, searchKeymap } from '@codemirror/search';
import { EditorState } from '@codemirror/state';
import { EditorView, drawSelection, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers } from '@codemirror/view';
import { tags } from '@lezer/highlight';
import type { Diagnostic } from '../api/types';
import { keyOffers, valueOffers, type Schema } from '../logic/schema';
import { placeAt } from '../logic/yamlPlace';

const colours = HighlightStyle.define([
  { tag: tags.propertyName, color: 'var(--yaml-key)' },
  { tag: [tags.string, tags.content], color: 'var(--yaml-value)' },
  { tag: tags.number, color: 'var(--yaml-value)' },
  { tag: [tags.comment, tags.lineComment], color: 'var(--yaml-comment)', fontStyle: 'italic' },
  { tag: [tags.punctuation, tags.separator, tags.squareBracket, tags.brace], color: 'var(--soft)' },
]);

function complete(schema: () => Schema | null) {
  return (context: CompletionContext): CompletionResult | null => {
    const root = schema();
    if (!root) return null;
    const place = placeAt(context.state.doc.toString(), context.pos);
    if (!context.explicit && place.kind === 'key' && place.typed === '') return null;
    const offers = place.kind === 'key' ? keyOffers(root, place.path) : valueOffers(root, place.path);
    const options = offers.map((o): Completion => ({
      label: o.label, detail: o.detail, info: o.info, type: place.kind === 'key' ? (o.group ? 'namespace' : 'property') : 'constant',
      apply: place.kind === 'key' ? (o.group ? `${o.label}:` : `${o.label}: `) : o.label,
    }));
    return options.length ? { from: place.from, options, validFor: /^[\w .^*/-]*$/ } : null;
  };
}

export interface YamlEditor {
  setText(text: string): void;
  setDiagnostics(list: Diagnostic[]): void;
  goTo(line: number): void;
  openSearch(): void;
  destroy(): void;
}

export function makeEditor(box: HTMLElement, start: string, schema: () => Schema | null, changed: (text: string) => void, undo: () => void, redo: () => void): YamlEditor {
  let outside = false;
  const view = new EditorView({
    parent: box,
    state: EditorState.create({
      doc: start,
      extensions: [
        lineNumbers(), lintGutter(), highlightActiveLine(), highlightActiveLineGutter(), drawSelection(), indentOnInput(), bracketMatching(), closeBrackets(),
        yaml(), syntaxHighlighting(colours), autocompletion({ override: [complete(schema)], activateOnTyping: true }),
        search({ top: true }), highlightSelectionMatches(),
        EditorView.contentAttributes.of({ 'aria-label': 'Model as YAML' }),
        // a common undo for form and editor
        keymap.of([
          { key: 'Mod-z', run: () => { undo(); return true; } }, { key: 'Mod-y', run: () => { redo(); return true; } }, { key: 'Mod-Shift-z', run: () => { redo(); return true; } },
          ...searchKeymap, ...closeBracketsKeymap, ...completionKeymap, ...defaultKeymap, indentWithTab,
        ]),
        EditorView.updateListener.of((u) => { if (u.docChanged && !outside) changed(u.state.doc.toString()); }),
      ],
    }),
  });
  return {
    setText(text) {
      const old = view.state.doc.toString();
      if (old === text) return;
      // only the differing part, so that cursor and scroll position are kept
      let from = 0;
      while (from < old.length && from < text.length && old[from] === text[from]) ++from;
      let end = 0;
      while (end < old.length - from && end < text.length - from && old[old.length - 1 - end] === text[text.length - 1 - end]) ++end;
      outside = true;
      view.dispatch({ changes: { from, to: old.length - end, insert: text.slice(from, text.length - end) } });
      outside = false;
    },
    setDiagnostics(list) {
      const { doc } = view.state;
      view.dispatch(setDiagnostics(view.state, list.map((d) => {
        const line = doc.line(Math.min(Math.max(1, d.line), doc.lines));
        const from = Math.min(line.to, line.from + Math.max(0, d.column - 1));
        return { from, to: Math.max(from, line.to), severity: d.severity, message: d.message };
      })));
    },
    goTo(number) {
      const line = view.state.doc.line(Math.min(Math.max(1, number), view.state.doc.lines));
      view.dispatch({ selection: { anchor: line.from }, effects: EditorView.scrollIntoView(line.from, { y: 'center' }) });
      view.focus();
    },
    openSearch() { openSearchPanel(view); },
    destroy() { view.destroy(); },
  };
}
