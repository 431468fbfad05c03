package dev.eventchain.eclipse.ui;

import dev.eventchain.eclipse.EventchainCore;
import dev.eventchain.eclipse.Preferences;
import org.eclipse.core.runtime.preferences.InstanceScope;
import org.eclipse.jface.preference.FieldEditorPreferencePage;
import org.eclipse.jface.preference.FileFieldEditor;
import org.eclipse.jface.preference.IntegerFieldEditor;
import org.eclipse.ui.IWorkbench;
import org.eclipse.ui.IWorkbenchPreferencePage;
import org.eclipse.ui.preferences.ScopedPreferenceStore;

/** The preference page for the program's location and the time limit of checks. */
public final class PreferencePage extends FieldEditorPreferencePage
    implements IWorkbenchPreferencePage {

  private static final int LONGEST_SECONDS = 3600;

  /** Called by the platform. */
  public PreferencePage() {
    super(GRID);
    setPreferenceStore(new ScopedPreferenceStore(InstanceScope.INSTANCE, EventchainCore.ID));
    setDescription(
        "Generate, Simulate and Run start the program 'eventchain'; models, rules and templates are"
            + " checked without it.");
  }

  @Override
  public void init(IWorkbench workbench) {
    // Nothing to prepare.
  }

  @Override
  protected void createFieldEditors() {
    FileFieldEditor program =
        new FileFieldEditor(
            Preferences.PROGRAM, "&Program (empty: the one on the PATH):", getFieldEditorParent());
    program.setEmptyStringAllowed(true);
    addField(program);
    IntegerFieldEditor limit =
        new IntegerFieldEditor(
            Preferences.TIME_LIMIT, "&Time limit of a constraint (s):", getFieldEditorParent());
    limit.setValidRange(1, LONGEST_SECONDS);
    addField(limit);
  }
}
