package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.XmlElement;
import dev.eventchain.openscenario.vocabulary.AttributeType;
import dev.eventchain.openscenario.vocabulary.DataType;
import dev.eventchain.openscenario.vocabulary.ElementType;
import dev.eventchain.openscenario.vocabulary.Vocabulary;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Replaces parameters, expressions and references to catalogs, of one file and one set of values.
 */
final class Resolver {

  private static final int MOST_ELEMENTS = 300_000;

  private static final int DEEPEST_REFERENCES = 30;

  private static final String REFERENCE = "CatalogReference";

  private final ScenarioFile file;
  private final Findings findings = new Findings();
  private final Map<String, Catalogs.Location> catalogFolders = new LinkedHashMap<>();
  private final Map<XmlElement, Boolean> sound = new HashMap<>();
  private final Deque<XmlElement> open = new ArrayDeque<>();
  private final DeclaredNames declared;
  private int elements;

  Resolver(ScenarioFile file) {
    this.file = file;
    this.declared = new DeclaredNames(file, findings);
  }

  ResolvedScenario resolve(Map<String, String> given) {
    findings.addAll(file.warnings());
    Scope scope = new Scope(null, findings);
    file.parameters().forEach(scope::declare);
    SourceLocation whole = SourceLocation.of(file.path());
    given.forEach((name, value) -> scope.assign(name, value, scope, whole));
    Map<String, String> parameters = scope.values();
    locateCatalogs(scope);
    ScenarioElement root = build(file.element(), Vocabulary.standard().root(), scope);
    Map<String, String> variables = variables(scope);
    Optional<Path> road = road(root);
    return new ResolvedScenario(file, root, parameters, variables, road, findings.endIfWrong());
  }

  /** Returns the elements of a file that has no parameters. */
  ScenarioElement tree(Findings into) {
    ScenarioElement root =
        build(file.element(), Vocabulary.standard().root(), new Scope(null, findings));
    into.addAll(findings.all());
    return root;
  }

  private void locateCatalogs(Scope scope) {
    for (XmlElement each :
        file.element().child("CatalogLocations").map(XmlElement::children).orElse(List.of())) {
      XmlElement directory = each.child("Directory").orElseThrow();
      SourceLocation place = directory.location("path");
      scope
          .evaluate(directory.attribute("path").orElseThrow(), place)
          .ifPresent(path -> catalogFolders.put(each.name(), new Catalogs.Location(path, place)));
    }
  }

  private Map<String, String> variables(Scope scope) {
    Map<String, String> values = new LinkedHashMap<>();
    for (ParameterDeclaration each : file.variables()) {
      DataType type = DataType.ofWord(each.type()).orElseThrow();
      Optional<String> value =
          scope
              .evaluate(each.value(), each.location())
              .flatMap(
                  text ->
                      AttributeValues.check(type, each.name(), text, each.location(), findings));
      if (values.putIfAbsent(each.name(), value.orElse("")) != null) {
        findings.add(
            DocumentRules.PARAMETER_DUPLICATE,
            "The variable `" + each.name() + "` is declared twice.",
            each.location(),
            "Leave one out.");
      }
    }
    return values;
  }

  private Optional<Path> road(ScenarioElement root) {
    Optional<ScenarioElement> logic =
        root.child("RoadNetwork").flatMap(network -> network.child("LogicFile"));
    if (logic.isEmpty() || logic.get().optional("filepath").orElse("").isBlank()) {
      return Optional.empty();
    }
    SourceLocation place = logic.get().location("filepath");
    try {
      Path found = file.folder().file(logic.get().text("filepath"), place);
      if (!Files.isRegularFile(found)) {
        findings.add(
            DocumentRules.PATH,
            "There is no file `" + logic.get().text("filepath") + "`.",
            place,
            "The path is relative to the folder of the scenario.");
      }
      return Optional.of(found);
    } catch (DiagnosticException e) {
      findings.addAll(e.diagnostics());
      return Optional.empty();
    }
  }

  private ScenarioElement build(XmlElement element, ElementType type, Scope around) {
    Scope scope = around;
    Optional<XmlElement> declarations = element.child("ParameterDeclarations");
    if (declarations.isPresent() && element != file.element() && element != open.peek()) {
      scope = new Scope(around, findings);
      ParameterDeclaration.allOf(declarations.get(), "parameterType").forEach(scope::declare);
      scope.values();
    }
    return content(element, type, scope);
  }

  private ScenarioElement content(XmlElement element, ElementType type, Scope scope) {
    if (++elements > MOST_ELEMENTS) {
      throw Findings.refused(
          DocumentRules.SIZE,
          "With its catalogs, the scenario has more than " + MOST_ELEMENTS + " elements.",
          element.location(),
          "");
    }
    Map<String, String> types = type.children();
    List<ScenarioElement> children = new ArrayList<>();
    for (XmlElement child : element.children()) {
      String childType = types.get(child.name());
      if (child.name().equals(REFERENCE)) {
        entry(child, type, scope).ifPresent(children::add);
      } else if (childType != null && !child.name().equals("ParameterDeclarations")) {
        children.add(build(child, Vocabulary.standard().element(childType), scope));
      }
    }
    Map<String, String> values = values(element, type, scope);
    declared.check(element, values);
    return LatestForm.of(type, element, values, children);
  }

  private Map<String, String> values(XmlElement element, ElementType type, Scope scope) {
    Map<String, String> values = new LinkedHashMap<>();
    element
        .attributes()
        .forEach(
            (name, written) -> {
              AttributeType attribute = type.attributes().get(name);
              boolean literal = type.name().equals("FileHeader") || name.equals("parameterRef");
              if (attribute != null) {
                boolean computed = !literal && written.strip().startsWith("$");
                value(element, attribute, written, computed ? Optional.of(scope) : Optional.empty())
                    .ifPresent(value -> values.put(name, value));
              }
            });
    return values;
  }

  /** Returns the value of an attribute. Its place, which takes long to find, is for findings. */
  private Optional<String> value(
      XmlElement element, AttributeType attribute, String written, Optional<Scope> scope) {
    if (scope.isEmpty()) {
      boolean isName = attribute.name().equals("parameterRef");
      String text = isName ? written.replaceFirst("^\\$", "") : written;
      Optional<String> value = AttributeValues.latest(attribute, text);
      return value.isPresent() ? value : checked(element, attribute, text);
    }
    return scope
        .get()
        .evaluate(written, element.location(attribute.name()))
        .flatMap(text -> checked(element, attribute, text));
  }

  private Optional<String> checked(XmlElement element, AttributeType attribute, String text) {
    return AttributeValues.check(attribute, text, element.location(attribute.name()), findings);
  }

  private Optional<ScenarioElement> entry(XmlElement reference, ElementType parent, Scope scope) {
    Map<String, String> names = values(reference, Vocabulary.standard().element(REFERENCE), scope);
    if (!names.containsKey("catalogName") || !names.containsKey("entryName")) {
      return Optional.empty();
    }
    SourceLocation place = reference.location();
    List<Catalogs.Location> folders = folders(parent, place);
    if (folders.isEmpty()) {
      return Optional.empty();
    }
    Catalogs.Reference wanted =
        new Catalogs.Reference(names.get("catalogName"), names.get("entryName"), place);
    return file.catalogs()
        .find(wanted, folders, findings)
        .filter(entry -> isFitting(entry, parent, wanted))
        .map(entry -> replaced(entry, reference, scope));
  }

  /** Returns the folders in which an element's entries may be. */
  private List<Catalogs.Location> folders(ElementType parent, SourceLocation place) {
    List<Catalogs.Location> folders = new ArrayList<>();
    List<String> kinds = new ArrayList<>();
    for (String child : parent.children().keySet()) {
      String kind = child + "Catalog";
      if (Vocabulary.standard().element("CatalogLocations").children().containsKey(kind)) {
        kinds.add(kind);
        Optional.ofNullable(catalogFolders.get(kind)).ifPresent(folders::add);
      }
    }
    if (folders.isEmpty()) {
      findings.add(
          DocumentRules.CATALOG_MISSING,
          "`CatalogLocations` does not say where the catalog is.",
          place,
          "Add `" + String.join("` or `", kinds) + "` with its `Directory`.");
    }
    return folders.stream().distinct().toList();
  }

  private boolean isFitting(
      Catalogs.Entry entry, ElementType parent, Catalogs.Reference reference) {
    String kind = entry.element().name();
    if (!parent.children().containsKey(kind)) {
      findings.add(
          DocumentRules.CATALOG_ENTRY,
          "`" + reference.entry() + "` is a `" + kind + "`, which does not belong here.",
          reference.place(),
          NearestName.hint(kind, parent.children().keySet()));
      return false;
    } else if (open.size() > DEEPEST_REFERENCES) {
      findings.add(
          DocumentRules.SIZE,
          "References to catalogs are nested more than " + DEEPEST_REFERENCES + " deep.",
          reference.place(),
          "");
      return false;
    } else if (open.contains(entry.element())) {
      findings.add(
          DocumentRules.CATALOG_CYCLE,
          "`" + reference.entry() + "` contains a reference that leads back to it.",
          reference.place(),
          "Leave that reference out.");
      return false;
    }
    ElementType type = Vocabulary.standard().element(parent.children().get(kind));
    return sound.computeIfAbsent(entry.element(), element -> isSound(entry, type));
  }

  private boolean isSound(Catalogs.Entry entry, ElementType type) {
    Findings wrong = new Findings();
    new StructureCheck(entry.version(), wrong).check(entry.element(), type);
    findings.addAll(wrong.all());
    return !Diagnostic.anyError(wrong.all());
  }

  private ScenarioElement replaced(Catalogs.Entry entry, XmlElement reference, Scope scope) {
    XmlElement element = entry.element();
    Scope own = new Scope(null, findings);
    element
        .child("ParameterDeclarations")
        .ifPresent(all -> ParameterDeclaration.allOf(all, "parameterType").forEach(own::declare));
    for (XmlElement each :
        reference.child("ParameterAssignments").map(XmlElement::children).orElse(List.of())) {
      String name = each.attribute("parameterRef").orElse("").replaceFirst("^\\$", "");
      String value = each.attribute("value").orElse("");
      own.assign(name, value, scope, each.location("value"));
    }
    own.values();
    open.push(element);
    ScenarioElement built = build(element, Vocabulary.standard().element(element.name()), own);
    open.pop();
    return built;
  }
}
