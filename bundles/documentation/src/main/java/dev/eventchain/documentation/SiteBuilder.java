package dev.eventchain.documentation;

import dev.eventchain.diagnostics.ResourceText;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/** Builds the site. */
public final class SiteBuilder {

  /** Folder of the handwritten pages, from the project's root. */
  static final String PAGES = "bundles/documentation/src/site";

  /** The folder of the site that the Javadoc plugin writes into. */
  static final String API = "apidocs";

  /** Pages in the order of the navigation: file name and link text. */
  private static final List<Map.Entry<String, String>> NAVIGATION =
      List.of(
          Map.entry("index", "Eventchain"),
          Map.entry("installation", "Installation"),
          Map.entry("tutorial", "Tutorial"),
          Map.entry("projects", "Projects"),
          Map.entry("ros2-workspaces", "ROS 2 workspaces"),
          Map.entry("requirements", "Requirements"),
          Map.entry("signal-catalogues", "Signal catalogues"),
          Map.entry("simulation", "Simulation"),
          Map.entry("scenarios", "Bench, scenarios, formulas"),
          Map.entry("campaigns", "Campaigns"),
          Map.entry("openscenario", "OpenSCENARIO and suites"),
          Map.entry("language-models", "Language models"),
          Map.entry("comparing-models", "Comparing models"),
          Map.entry("ros2-carla", "ROS 2 and CARLA"),
          Map.entry("constraints", "Constraints"),
          Map.entry("templates", "Templates"),
          Map.entry("acceleo", "Coming from Acceleo"),
          Map.entry("operations", "Operations"),
          Map.entry("diagrams", "Diagrams"),
          Map.entry("build-server", "Build servers"),
          Map.entry("evidence", "Evidence"),
          Map.entry("traces", "Traces of ROS 2"),
          Map.entry("coding-agents", "Coding agents"),
          Map.entry("eclipse", "Eclipse"),
          Map.entry("vscode", "VS Code"),
          Map.entry("editors", "Other editors"),
          Map.entry("java", "Java API"),
          Map.entry("formats", "File formats"),
          Map.entry("commands", "Commands"),
          Map.entry("rules", "Findings"),
          Map.entry("extending", "Extending it"));

  private final Path root;
  private final Map<String, String> pages = new TreeMap<>();

  /**
   * Creates a builder.
   *
   * @param root the project's root folder
   */
  SiteBuilder(Path root) {
    this.root = root;
  }

  /**
   * Builds the site. Pages of an earlier build that it no longer has are deleted; the Javadoc in
   * {@value #API} is left alone.
   *
   * @param arguments the project's root folder, and the folder to write into
   */
  public static void main(String[] arguments) throws IOException {
    write(new SiteBuilder(Path.of(arguments[0]).normalize()).files(), Path.of(arguments[1]));
  }

  /** Makes the folder hold these files and no other pages. */
  static void write(Map<String, String> files, Path site) throws IOException {
    for (Map.Entry<String, String> file : files.entrySet()) {
      Path path = site.resolve(file.getKey());
      Files.createDirectories(path.getParent());
      Files.writeString(path, file.getValue());
    }
    for (Path page : pages(site)) {
      if (!files.containsKey(site.relativize(page).toString().replace('\\', '/'))) {
        Files.delete(page);
      }
    }
  }

  private static List<Path> pages(Path site) throws IOException {
    try (Stream<Path> files = Files.walk(site)) {
      return files
          .filter(file -> !file.startsWith(site.resolve(API)))
          .filter(file -> file.toString().endsWith(".html"))
          .toList();
    }
  }

  /** Returns the content of each file of the site, by its name. */
  Map<String, String> files() throws IOException {
    String acceleo = Files.readString(root.resolve("bundles/mde/m2t/ACCELEO.md"));
    pages.put("acceleo", acceleo.replace("(OPERATIONS.md)", "(operations.md)"));
    pages.put("operations", Files.readString(root.resolve("bundles/mde/m2t/OPERATIONS.md")));
    for (String name : List.of("scenarios", "campaigns", "openscenario")) {
      String page = Files.readString(root.resolve(PAGES).resolve(name + ".md"));
      pages.put(name, SimulationReference.inserted(page, root));
    }
    pages.put("commands", ReferencePages.commands());
    pages.put("rules", ReferencePages.rules());
    for (Map.Entry<String, String> entry : NAVIGATION) {
      if (!pages.containsKey(entry.getKey())) {
        Path page = root.resolve(PAGES).resolve(entry.getKey() + ".md");
        pages.put(entry.getKey(), JavaSnippets.inserted(Files.readString(page), root));
      }
    }
    pages.putAll(ReferencePages.ofEachRule());

    Map<String, String> files = new TreeMap<>();
    pages.forEach(
        (name, text) -> files.put(name + ".html", PageTemplate.page(name, text, NAVIGATION)));
    files.put("style.css", resource("style.css"));
    return files;
  }

  static String resource(String name) {
    return ResourceText.of(SiteBuilder.class, name);
  }
}
