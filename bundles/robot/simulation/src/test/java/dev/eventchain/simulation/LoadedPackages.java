package dev.eventchain.simulation;

import dev.eventchain.model.eventchain.EventchainPackage;
import java.util.List;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcorePackage;
import org.junit.jupiter.api.extension.Extension;

/**
 * Loads the metamodels before any test. EMF's packages refer to each other while they are
 * initialised: two threads that begin at different ones wait for each other for ever.
 */
public final class LoadedPackages implements Extension {

  static final List<EPackage> ALL = List.of(EcorePackage.eINSTANCE, EventchainPackage.eINSTANCE);
}
