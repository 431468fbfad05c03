package dev.eventchain.eclipse;

import dev.eventchain.model.eventchain.EventchainPackage;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EValidator;

/**
 * The metamodel of event chains as EMF's registry gets it: whoever reads a model of its namespace
 * has {@link ChainValidator} with it.
 */
public final class RegisteredPackage {

  /** The metamodel; EMF looks for a field of this name. */
  public static final EPackage eINSTANCE = register();

  private RegisteredPackage() {}

  private static EPackage register() {
    EPackage eventchain = EventchainPackage.eINSTANCE;
    EValidator.Registry.INSTANCE.put(eventchain, new ChainValidator());
    return eventchain;
  }
}
