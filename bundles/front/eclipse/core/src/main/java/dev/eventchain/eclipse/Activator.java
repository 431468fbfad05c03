package dev.eventchain.eclipse;

import java.util.Objects;
import org.osgi.framework.BundleActivator;
import org.osgi.framework.BundleContext;

/**
 * Registers the validator as soon as anything of this bundle is used: who had the metamodel's
 * classes before would get round EMF's registry, and so round {@link RegisteredPackage}.
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
