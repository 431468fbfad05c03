package dev.eventchain.eclipse.install;

import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.ServiceLoader;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.osgi.framework.Bundle;
import org.osgi.framework.BundleException;
import org.osgi.framework.Constants;
import org.osgi.framework.launch.Framework;
import org.osgi.framework.launch.FrameworkFactory;
import org.osgi.framework.wiring.BundleWire;
import org.osgi.framework.wiring.BundleWiring;
import org.osgi.framework.wiring.FrameworkWiring;

/** A framework that resolves the bundles of an installation without starting them. */
final class Wiring implements AutoCloseable {

  private static final Pattern CLASS = Pattern.compile("\\sclass=\"(dev\\.eventchain\\.[\\w.$]+)");

  private final Framework framework;
  private final SortedMap<String, Bundle> bundles = new TreeMap<>();

  Wiring(Map<String, Path> installed, Path storage) throws BundleException {
    framework =
        ServiceLoader.load(FrameworkFactory.class)
            .findFirst()
            .orElseThrow()
            .newFramework(Map.of(Constants.FRAMEWORK_STORAGE, storage.toString()));
    framework.init();
    for (Map.Entry<String, Path> entry : installed.entrySet()) {
      // This is the framework itself, with its fragment.
      if (!entry.getKey().equals("org.eclipse.osgi")
          && !entry.getKey().startsWith("org.eclipse.osgi.compatibility")) {
        String location = "reference:" + entry.getValue().toUri();
        bundles.put(entry.getKey(), framework.getBundleContext().installBundle(location));
      }
    }
  }

  /** Returns the reason why a bundle cannot be wired; empty if it can be. */
  String unresolved(String name) {
    Bundle bundle = bundles.get(name);
    if (bundle == null) {
      return "not installed";
    }
    if (framework.adapt(FrameworkWiring.class).resolveBundles(List.of(bundle))) {
      return "";
    }
    try {
      bundle.start();
    } catch (BundleException e) {
      return e.getMessage();
    }
    return "started, although it was not resolved";
  }

  /** Returns the symbolic names of the bundles that a resolved bundle is wired to. */
  SortedSet<String> providers(String name) {
    SortedSet<String> providers = new TreeSet<>();
    for (BundleWire wire : bundles.get(name).adapt(BundleWiring.class).getRequiredWires(null)) {
      providers.add(wire.getProvider().getSymbolicName());
    }
    return providers;
  }

  /** Returns the classes of ours that a bundle's extensions name. */
  SortedSet<String> named(String name) throws IOException {
    SortedSet<String> classes = new TreeSet<>();
    URL extensions = bundles.get(name).getEntry("plugin.xml");
    if (extensions != null) {
      try (InputStream in = extensions.openStream()) {
        Matcher matcher = CLASS.matcher(new String(in.readAllBytes(), StandardCharsets.UTF_8));
        while (matcher.find()) {
          classes.add(matcher.group(1));
        }
      }
    }
    return classes;
  }

  /** Loads a class and its dependencies with the class loader of a bundle. */
  Class<?> load(String name, String className) throws ClassNotFoundException {
    Class<?> loaded = bundles.get(name).loadClass(className);
    Objects.requireNonNull(loaded.getDeclaredMethods());
    return loaded;
  }

  @Override
  public void close() throws BundleException {
    framework.stop();
    try {
      framework.waitForStop(0);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // a clean end is not needed
    }
  }
}
