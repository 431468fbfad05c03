package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.XmlElement;
import dev.eventchain.openscenario.vocabulary.Version;
import dev.eventchain.openscenario.vocabulary.Vocabulary;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * A file in OpenSCENARIO XML as it stands, held against the vocabulary of the version that it
 * declares. Immutable; catalogs that it leads to are read once.
 */
public final class ScenarioFile {

  /** Kind of a file by its content. */
  public enum Kind {
    /** A scenario, which can be resolved. */
    SCENARIO,
    /** Entries that scenarios refer to. */
    CATALOG,
    /** Values for the parameters of a scenario: {@link Variations}. */
    DISTRIBUTION
  }

  private final Path path;
  private final Folder folder;
  private final XmlElement element;
  private final Version version;
  private final Catalogs catalogs;
  private final List<Diagnostic> warnings;

  private ScenarioFile(
      Path path, Folder folder, XmlElement element, Version version, List<Diagnostic> warnings) {
    this.path = path;
    this.folder = folder;
    this.element = element;
    this.version = version;
    this.catalogs = new Catalogs(folder);
    this.warnings = warnings;
  }

  /** Reads a file that leads to files in its own folder only. */
  public static ScenarioFile read(Path file) {
    Path folder = file.toAbsolutePath().normalize().getParent();
    return read(file, folder == null ? file : folder);
  }

  /**
   * Reads a file.
   *
   * @param root the folder outside of which no file is read that this one leads to
   * @throws DiagnosticException (INPUT) if it cannot be read or is not XML; (FINDINGS) with all
   *     findings if it is not what its version of the standard says
   */
  public static ScenarioFile read(Path file, Path root) {
    ScenarioFile loaded = load(file, root);
    Findings findings = new Findings();
    new StructureCheck(loaded.version, findings)
        .check(loaded.element, Vocabulary.standard().root());
    return new ScenarioFile(
        file, loaded.folder, loaded.element, loaded.version, findings.endIfWrong());
  }

  /** Reads a file of which only the header is checked. */
  static ScenarioFile load(Path file, Path root) {
    new Folder(root, root).find(file.toAbsolutePath().toString(), SourceLocation.of(file));
    XmlElement element = SourceFile.read(file);
    Folder folder = new Folder(root, file.resolveSibling("").normalize());
    return new ScenarioFile(file, folder, element, SourceFile.version(element), List.of());
  }

  public Path path() {
    return path;
  }

  /** Returns the folder outside of which nothing is read. */
  public Path root() {
    return folder.root();
  }

  public Kind kind() {
    if (element.child("Catalog").isPresent()) {
      return Kind.CATALOG;
    }
    boolean values = element.child("ParameterValueDistribution").isPresent();
    return values ? Kind.DISTRIBUTION : Kind.SCENARIO;
  }

  public ScenarioHeader header() {
    XmlElement header = element.child("FileHeader").orElseThrow();
    return new ScenarioHeader(
        version.toString(),
        header.attribute("author").orElse(""),
        header.attribute("description").orElse(""),
        header.attribute("date").orElse(""));
  }

  /** Returns the parameters that may be given values, in their order. */
  public List<ParameterDeclaration> parameters() {
    return declared("ParameterDeclarations", "parameterType");
  }

  /** Returns the variables, in their order. */
  public List<ParameterDeclaration> variables() {
    return declared("VariableDeclarations", "variableType");
  }

  private List<ParameterDeclaration> declared(String child, String typeAttribute) {
    return element
        .child(child)
        .map(all -> ParameterDeclaration.allOf(all, typeAttribute))
        .orElse(List.of());
  }

  /** Returns the path of the OpenDRIVE file as it is written. */
  public Optional<String> roadNetwork() {
    return element
        .child("RoadNetwork")
        .flatMap(network -> network.child("LogicFile"))
        .flatMap(file -> file.attribute("filepath"));
  }

  /** Returns the folders of catalogs as they are written, by element: {@code VehicleCatalog}. */
  public Map<String, String> catalogLocations() {
    Map<String, String> locations = new LinkedHashMap<>();
    for (XmlElement each :
        element.child("CatalogLocations").map(XmlElement::children).orElse(List.of())) {
      each.child("Directory")
          .flatMap(directory -> directory.attribute("path"))
          .ifPresent(written -> locations.put(each.name(), written));
    }
    return locations;
  }

  /** Returns the root as it is written. */
  public XmlElement element() {
    return element;
  }

  /** Returns what to know about the file although it can be read. */
  public List<Diagnostic> warnings() {
    return warnings;
  }

  /**
   * Returns the scenario with values for its parameters.
   *
   * @param parameters values for some of the parameters; the others have those that they are
   *     declared with
   * @throws DiagnosticException (FINDINGS) with all findings, if it is no scenario, a parameter is
   *     unknown, or a value, an expression or an entry of a catalog is wrong
   */
  public ResolvedScenario resolve(Map<String, String> parameters) {
    if (kind() != Kind.SCENARIO) {
      throw Findings.refused(
          DocumentRules.KIND,
          "This is no scenario but a " + kind().name().toLowerCase(Locale.ROOT) + ".",
          element.location(),
          "Name the file of a scenario.");
    }
    return new Resolver(this).resolve(parameters);
  }

  Folder folder() {
    return folder;
  }

  Version version() {
    return version;
  }

  Catalogs catalogs() {
    return catalogs;
  }
}
