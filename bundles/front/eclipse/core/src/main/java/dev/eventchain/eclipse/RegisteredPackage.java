package dev.eventchain.eclipse;

import dev.eventchain.model.eventchain.EventchainPackage;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EValidator;

/**
 * The event chain metamodel for EMF's registry. Readers of its models get {@link ChainValidator},
 * too.
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
