package dev.eventchain.pipeline.generate;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.pipeline.stage.PythonImports;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;

/** Imports of the components' Python files, and the packages that provide them. */
final class ComponentImports {

  /** Names of one package: the rosdep key, and the name on PyPI. */
  private record Provider(String rosdep, String pypi) {}

  /**
   * Providers of imports beyond Python itself: NumPy for generated components; existing ones may
   * also use other packages of their environment.
   */
  private static final Map<String, Provider> PROVIDERS =
      Map.of(
          "numpy", new Provider("python3-numpy", "numpy"),
          "ruamel", new Provider("python3-ruamel.yaml", "ruamel.yaml"),
          "typing_extensions", new Provider("python3-typing-extensions", "typing_extensions"));

  /** Packages of ROS 2 are their own rosdep keys; none of them is on PyPI. */
  private static final Pattern OF_ROS =
      Pattern.compile("rclpy|ament_index_python|tf2_ros|tf2_py|\\w+_(msgs|srvs|interfaces)");

  private final MessageCatalog messages;
  private final boolean pip;
  private final Set<String> helpers;
  private final Set<String> rosdepKeys = new TreeSet<>();
  private final Set<String> pipNames = new TreeSet<>();
  private final List<Diagnostic> unknown = new ArrayList<>();

  /**
   * Creates an empty collection of imports.
   *
   * @param messages message packages are packages of ROS 2
   * @param pip true if pip installs dependencies, false for rosdep: dependencies that it does not
   *     know are findings
   * @param helpers modules of the project beside the components
   */
  ComponentImports(MessageCatalog messages, boolean pip, Set<String> helpers) {
    this.messages = messages;
    this.pip = pip;
    this.helpers = helpers;
  }

  /** Returns the packages of the imports by rosdep keys, in order. */
  Set<String> rosdepKeys() {
    return rosdepKeys;
  }

  /** Returns the packages of the imports by PyPI names, in order. */
  Set<String> pipNames() {
    return pipNames;
  }

  /** Returns a warning for each import of an unknown package. */
  List<Diagnostic> unknown() {
    return unknown;
  }

  /**
   * Adds the imports of a file, wherever they are in it.
   *
   * @param importer the component or module, for users
   */
  void add(String importer, SourceText file) {
    PythonImports.modules(file.text())
        .forEach(
            (module, offset) -> {
              Optional<Provider> known = Optional.ofNullable(PROVIDERS.get(module));
              Optional<String> pipName = known.map(Provider::pypi);
              Optional<String> rosdepKey =
                  isOfRos(module) ? Optional.of(module) : known.map(Provider::rosdep);
              pipName.ifPresent(pipNames::add);
              rosdepKey.ifPresent(rosdepKeys::add);
              boolean isKnown = (pip ? pipName : rosdepKey).isPresent() || helpers.contains(module);
              if (!isKnown && !PythonImports.isStandard(module)) {
                unknown.add(unknown(importer, module, file.at(offset)));
              }
            });
  }

  private boolean isOfRos(String module) {
    return OF_ROS.matcher(module).matches()
        || messages.names().stream().anyMatch(name -> name.startsWith(module + "/"));
  }

  private Diagnostic unknown(String importer, String module, SourceLocation place) {
    String tool = pip ? "pip" : "rosdep";
    String file = pip ? "pyproject.toml" : "package.xml";
    return Diagnostic.of(
            GenerateRules.DEPENDENCY_UNKNOWN,
            "%s imports '%s', and %s does not list the package that provides it: its name for %s is not known."
                .formatted(importer, module, file, tool),
            place)
        .withHint("Add it to the copy of " + file + " that you build.");
  }
}
