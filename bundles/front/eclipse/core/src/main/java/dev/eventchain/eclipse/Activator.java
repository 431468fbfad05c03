package dev.eventchain.eclipse;

import java.util.Objects;
import org.osgi.framework.BundleActivator;
import org.osgi.framework.BundleContext;

/**
 * Registers the validator on the first use of this bundle. Code that loaded the metamodel's classes
 * earlier would bypass EMF's registry, and so {@link RegisteredPackage}.
 */
public final class Activator implements BundleActivator {

  @Override
  public void start(BundleContext context) {
    Objects.requireNonNull(RegisteredPackage.eINSTANCE);
  }

  @Override
  public void stop(BundleContext context) {
    // The registries of EMF end with the platform.
  }
}
