package dev.eventchain.agents;

import dev.eventchain.model.eventchain.EventchainPackage;
import java.util.List;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcorePackage;
import org.junit.jupiter.api.extension.Extension;

/** Loads the metamodels before any test starts, since two threads that load them can lock up. */
public final class LoadedMetamodels implements Extension {

  static final List<EPackage> ALL = List.of(EcorePackage.eINSTANCE, EventchainPackage.eINSTANCE);
}
