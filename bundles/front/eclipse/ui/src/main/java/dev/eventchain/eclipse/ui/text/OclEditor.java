package dev.eventchain.eclipse.ui.text;

/** The editor of files with constraints. */
public final class OclEditor extends CodeEditor {

  /** Called by the platform. */
  public OclEditor() {
    super(Language.OCL);
  }
}
