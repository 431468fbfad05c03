package dev.eventchain.eclipse.ui.text;

/** The editor of files with constraints. */
public final class OclEditor extends CodeEditor {

  /** Made by the platform. */
  public OclEditor() {
    super(Language.OCL);
  }
}
