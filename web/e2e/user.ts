// A user with counted actions: a click, a drag, a typed or pasted value count as one each, waiting and reading as none.
import type { Locator, Page } from 'playwright-core';

type Target = string | Locator;

export class User {
  actions = 0;
  constructor(readonly page: Page) {}

  private find(target: Target): Locator { return typeof target === 'string' ? this.page.locator(target).first() : target; }

  async click(target: Target): Promise<void> {
    ++this.actions;
    await this.find(target).click();
  }

  /** Enters a value into a field, which is committed when the field is left. */
  async type(target: Target, value: string): Promise<void> {
    ++this.actions;
    const field = this.find(target);
    await field.fill(value);
    await field.blur();
  }

  /** Replaces the line of an editor that begins at the caret. */
  async retypeLine(text: string): Promise<void> {
    ++this.actions;
    await this.page.keyboard.press('Shift+End');
    await this.page.keyboard.insertText(text);
  }

  /** Pastes a text copied from a spreadsheet with Ctrl+V. */
  async paste(text: string): Promise<void> {
    ++this.actions;
    await this.page.evaluate((copied) => {
      const data = new DataTransfer();
      data.setData('text/plain', copied);
      (document.activeElement ?? document.body).dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }));
    }, text);
  }
}
