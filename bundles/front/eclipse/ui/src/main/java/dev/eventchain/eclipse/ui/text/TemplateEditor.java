package dev.eventchain.eclipse.ui.text;

/** The editor of files with templates. */
public final class TemplateEditor extends CodeEditor {

  /** Called by the platform. */
  public TemplateEditor() {
    super(Language.TEMPLATE);
  }
}
