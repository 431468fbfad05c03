package dev.eventchain.project;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import dev.eventchain.catalogue.SignalCatalogue;
import dev.eventchain.catalogue.signal.CatalogueSignal;
import dev.eventchain.description.ChainNames;
import dev.eventchain.description.EventChainReader;
import dev.eventchain.description.SoftwareBaseNames;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.jsonmodels.JsonDocument;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.model.PythonNames;
import dev.eventchain.model.Signal;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.ComponentOrigin;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * Software base of a project: the components of {@code components.json} with their files, the
 * signals of {@code signals.json}, and those of a catalogue.
 */
public final class SoftwareBase {

  /**
   * An existing component.
   *
   * @param implementation the kind: a class that needs a node around it, or a node
   * @param file its Python file
   * @param node how it is hosted, if it is a node in Python that is there as it is
   * @param location the location of its description
   */
  public record Component(
      String name,
      ComponentImplementation implementation,
      Path file,
      Optional<HostedNode> node,
      SourceLocation location) {}

  private final Map<String, Component> components;
  private final String componentsText;
  private final String signalsText;
  private final Optional<List<Signal>> signals;
  private final Optional<SignalCatalogue> catalogue;
  private final List<Diagnostic> diagnostics;
  private final EventChain described;

  private SoftwareBase(
      Map<String, Component> components,
      EventChain described,
      String componentsText,
      String signalsText,
      Optional<List<Signal>> signals,
      Optional<SignalCatalogue> catalogue,
      List<Diagnostic> diagnostics) {
    this.components = components;
    this.described = described;
    this.componentsText = componentsText;
    this.signalsText = signalsText;
    this.signals = signals.map(List::copyOf);
    this.catalogue = catalogue;
    this.diagnostics = List.copyOf(diagnostics);
  }

  /**
   * Reads a software base. A missing, unreadable or malformed file is a finding, and its content
   * counts as unknown.
   *
   * @param folder the folder {@code software-base}
   */
  public static SoftwareBase read(Path folder) {
    return read(folder, Optional.empty());
  }

  /** As {@link #read(Path)}, with the signals and findings of a catalogue. */
  static SoftwareBase read(Path folder, Optional<CatalogueSettings> named) {
    List<Diagnostic> diagnostics = new ArrayList<>();
    Optional<SignalCatalogue> catalogue = named.map(it -> SignalCatalogue.read(it.source()));
    catalogue.map(SignalCatalogue::diagnostics).ifPresent(diagnostics::addAll);
    catalogue.map(it -> named.orElseThrow().check(it)).ifPresent(diagnostics::addAll);
    Map<String, Component> components = new LinkedHashMap<>();
    EventChain described = EventchainFactory.eINSTANCE.createEventChain();
    Optional<Text> componentsFile = existing(folder, SoftwareBaseNames.COMPONENTS, diagnostics);
    if (componentsFile.isPresent()) {
      Document json = componentsFile.get().json();
      Modeled<EventChain> read = EventChainReader.readExisting(json);
      diagnostics.addAll(read.diagnostics());
      described = read.root();
      components = new Reader(folder, json, diagnostics).components();
    }
    Optional<Text> signalsFile = existing(folder, SoftwareBaseNames.SIGNALS, diagnostics);
    Optional<List<Signal>> signals =
        signalsFile.map(file -> new SignalReader(file.json(), diagnostics).read());
    return new SoftwareBase(
        components,
        described,
        componentsFile.map(Text::text).orElse("[]"),
        signalsFile.map(Text::text).orElse("[]"),
        signals.map(own -> joined(own, catalogue.map(SignalCatalogue::topics).orElse(List.of()))),
        catalogue,
        diagnostics);
  }

  private static List<Signal> joined(List<Signal> own, List<Signal> others) {
    List<Signal> all = new ArrayList<>(own);
    all.addAll(others);
    return all;
  }

  /**
   * Returns this software base with some signals of the catalogue only, as language models see it;
   * unchanged without a catalogue.
   */
  public SoftwareBase offering(List<CatalogueSignal> some) {
    if (catalogue.isEmpty()) {
      return this;
    }
    ArrayNode text = JsonNodeFactory.instance.arrayNode();
    for (String part : List.of(signalsText, catalogue.get().asJson(some))) {
      JsonDocument.parse(SourceText.of(SoftwareBaseNames.SIGNALS, part)).root().forEach(text::add);
    }
    List<Signal> all = signals.orElse(List.of());
    List<Signal> own = all.subList(0, all.size() - catalogue.get().topics().size());
    return new SoftwareBase(
        components,
        described,
        componentsText,
        text.toString(),
        Optional.of(joined(own, catalogue.get().topics(some))),
        catalogue,
        diagnostics);
  }

  /** Returns the catalogue of signals, if the project names one. */
  public Optional<SignalCatalogue> catalogue() {
    return catalogue;
  }

  /** Returns the software base of a chain outside any project: no components, vehicle unknown. */
  public static SoftwareBase unknown() {
    return new SoftwareBase(
        Map.of(),
        EventchainFactory.eINSTANCE.createEventChain(),
        "[]",
        "[]",
        Optional.empty(),
        Optional.empty(),
        List.of());
  }

  /**
   * Marks the components of a chain as existing if they are in the software base, otherwise as
   * generated.
   */
  public void markExisting(EventChain chain) {
    for (SoftwareNode node : chain.getSoftware()) {
      Optional<Component> existing = find(node.getName());
      node.setOrigin(existing.isPresent() ? ComponentOrigin.EXISTING : ComponentOrigin.GENERATED);
      existing.ifPresent(component -> node.setImplementation(component.implementation()));
    }
  }

  /**
   * Adds what language models are not asked for, from the description or else from this software
   * base: the budgets of components, which of their inputs are synchronized, what executes them,
   * and units of values within them.
   *
   * @param described the chain read directly from its description
   */
  public void addUnasked(EventChain chain, EventChain described) {
    for (SoftwareNode node : chain.getSoftware()) {
      described.getSoftware().stream()
          .filter(other -> Objects.equals(other.getName(), node.getName()))
          .findFirst()
          .ifPresent(other -> UnaskedFacts.add(node, other));
      described(String.valueOf(node.getName())).ifPresent(other -> UnaskedFacts.add(node, other));
    }
  }

  /** Text of a file and its parsed content. */
  private record Text(String text, Document json) {}

  /** Returns a file; a missing one is a finding, since its content could not be checked. */
  private static Optional<Text> existing(Path folder, String name, List<Diagnostic> diagnostics) {
    Path file = folder.resolve(name);
    if (!Files.exists(file, LinkOption.NOFOLLOW_LINKS)) {
      diagnostics.add(
          Diagnostic.of(FileRules.MISSING, "There is no such file.", SourceLocation.of(file))
              .withHint("Write `[]` into it if there is nothing to describe."));
      return Optional.empty();
    }
    try {
      SourceText text = SourceText.read(file);
      return Optional.of(new Text(text.text(), JsonDocument.parse(text)));
    } catch (DiagnosticException e) {
      diagnostics.addAll(e.diagnostics());
      return Optional.empty();
    }
  }

  /** Returns the components, in the order of the file. */
  public List<Component> components() {
    return List.copyOf(components.values());
  }

  /** Returns the component with a name. */
  public Optional<Component> find(String name) {
    return Optional.ofNullable(components.get(name));
  }

  /** Returns the text of {@code components.json}; an empty array without such a file. */
  public String componentsText() {
    return componentsText;
  }

  /**
   * Returns the text of {@code signals.json}; an empty array without such a file. Signals of the
   * catalogue are in it only where some are {@link #offering offered}.
   */
  public String signalsText() {
    return signalsText;
  }

  /**
   * Returns the signals, in the order of the file, and then those of the catalogue; empty without
   * the file, so that the vehicle is unknown.
   */
  public Optional<List<Signal>> signals() {
    return signals;
  }

  /** Returns the message types that the components read and write, as written. */
  public SortedSet<String> messageTypes() {
    return described.getData().stream()
        .map(Data::getMessageType)
        .filter(Objects::nonNull)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** Returns the descriptions of the components, in the order of the file. */
  public List<SoftwareNode> descriptions() {
    return List.copyOf(described.getSoftware());
  }

  /** Returns the description of a component, of which a chain may use a part. */
  Optional<SoftwareNode> described(String name) {
    return descriptions().stream().filter(node -> node.getName().equals(name)).findFirst();
  }

  /** Returns the findings about the files. */
  public List<Diagnostic> diagnostics() {
    return diagnostics;
  }

  /** Returns the components of a chain that are not in the software base, in chain order. */
  public List<SoftwareNode> missing(EventChain chain) {
    return chain.getSoftware().stream()
        .filter(node -> !components.containsKey(node.getName()))
        .toList();
  }

  /**
   * Checks that a chain uses the existing components as described. Topics, fields, values and
   * conversions of units must be the same. So must units, quality of service, ages, safe values,
   * frequency, execution times, memory and synchronized inputs, where they are stated. An omitted
   * output is a warning, any other deviation an error.
   *
   * @param locator returns the locations of the features of the chain's elements
   */
  public List<Diagnostic> check(
      EventChain chain, BiFunction<EObject, EStructuralFeature, SourceLocation> locator) {
    List<Diagnostic> found = new ArrayList<>();
    for (SoftwareNode node : chain.getSoftware()) {
      described(String.valueOf(node.getName()))
          .ifPresent(existing -> new ReuseCheck(existing, node, locator, found).check());
    }
    return found;
  }

  private static final class Reader {
    private final Path folder;
    private final Document text;
    private final List<Diagnostic> diagnostics;

    Reader(Path folder, Document text, List<Diagnostic> diagnostics) {
      this.folder = folder;
      this.text = text;
      this.diagnostics = diagnostics;
    }

    Map<String, Component> components() {
      Map<String, Component> components = new LinkedHashMap<>();
      for (int i = 0; text.root().isArray() && i < text.root().size(); i++) {
        String pointer = "/" + i;
        if (text.root().at(pointer).isObject()) {
          text.object(pointer, diagnostics::add)
              .flatMap(json -> component(json, pointer))
              .ifPresent(component -> components.putIfAbsent(component.name(), component));
        }
      }
      return components;
    }

    /** Reads a component and checks its file; its description is checked when read as a chain. */
    private Optional<Component> component(ObjectReader json, String pointer) {
      String name = text.root().at(pointer).path(ChainNames.NAME).asText();
      if (!PythonNames.isFreeIdentifier(name)) {
        return Optional.empty();
      }
      String file = json.text(ChainNames.FILE).orElse("components/" + name + ".py");
      Path path = folder.resolve(file).normalize();
      if (!path.startsWith(folder.normalize())) {
        json.find(
            ProjectRules.MODELER_COMPONENT_FILE,
            "The file '" + file + "' is not in the software base.",
            json.at(ChainNames.FILE));
        return Optional.empty();
      }
      ComponentImplementation implementation = implementation(json);
      Optional<ObjectReader> hosted = json.object(ChainNames.NODE);
      if (hosted.isPresent() && implementation == ComponentImplementation.COMPONENT) {
        json.find(
            ProjectRules.MODELER_COMPONENT_NODE,
            "The component '" + name + "' is no node: it has no implementation 'node'.",
            json.at(ChainNames.NODE));
        return Optional.empty();
      }
      if (implementation == ComponentImplementation.COMPONENT || hosted.isPresent()) {
        requireFile(json, name, file, path);
      }
      Optional<HostedNode> node =
          hosted.filter(it -> Files.isRegularFile(path)).map(it -> HostedNode.read(it, path));
      return Optional.of(new Component(name, implementation, path, node, json.location()));
    }

    private static void requireFile(ObjectReader json, String name, String file, Path path) {
      if (!Files.isRegularFile(path)) {
        json.find(
            ProjectRules.MODELER_COMPONENT_FILE,
            "The component '" + name + "' has no file " + file + ".",
            json.location());
      }
    }

    private ComponentImplementation implementation(ObjectReader json) {
      String written = json.text(ChainNames.IMPLEMENTATION).orElse("component");
      return switch (written) {
        case "component" -> ComponentImplementation.COMPONENT;
        case "node" -> ComponentImplementation.NODE;
        default -> {
          json.find(
              ProjectRules.MODELER_COMPONENT_IMPLEMENTATION,
              "'" + written + "' is not an implementation; write 'component' or 'node'.",
              json.at(ChainNames.IMPLEMENTATION));
          yield ComponentImplementation.COMPONENT;
        }
      };
    }
  }
}
