package dev.eventchain.eclipse.ui.editor.model;

import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.xmi.LoadedModel;
import dev.eventchain.xmi.XmiStore;
import java.util.List;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.edit.command.ChangeCommand;
import org.eclipse.emf.edit.domain.AdapterFactoryEditingDomain;
import org.eclipse.emf.edit.domain.EditingDomain;
import org.eclipse.emf.edit.provider.ReflectiveItemProviderAdapterFactory;

/** An event chain read from a file, with the changes since then. */
public final class EditedModel {

  private final LoadedModel loaded;
  private final EventChain chain;
  private final EditStack stack = new EditStack();
  private final AdapterFactoryEditingDomain domain;

  EditedModel(LoadedModel loaded, EventChain chain) {
    this.loaded = loaded;
    this.chain = chain;
    domain =
        new AdapterFactoryEditingDomain(
            new ReflectiveItemProviderAdapterFactory(), stack, loaded.resource().getResourceSet());
  }

  public EventChain chain() {
    return chain;
  }

  LoadedModel loaded() {
    return loaded;
  }

  public EditStack stack() {
    return stack;
  }

  public EditingDomain domain() {
    return domain;
  }

  /**
   * Returns the content of the saved file, as the command line writes it.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException if XML cannot hold it
   */
  public byte[] bytes() {
    return XmiStore.toBytes(List.copyOf(loaded.resource().getContents()));
  }

  /**
   * Changes the model in one step, which can be undone.
   *
   * @param label the name of the change, such as "delete"
   */
  public void change(String label, Runnable work) {
    stack.execute(
        new ChangeCommand(loaded.resource()) {
          {
            setLabel(label);
          }

          @Override
          protected void doExecute() {
            work.run();
          }
        });
  }

  /** Sets a feature in one step, null for none; does nothing if it already has the value. */
  public void set(EObject element, EStructuralFeature feature, Object value) {
    boolean same =
        value == null
            ? !element.eIsSet(feature)
            : element.eIsSet(feature) && value.equals(element.eGet(feature));
    if (!same) {
      stack.type(element, feature, value);
      stack.endTyping();
    }
  }
}
