package dev.eventchain.pipeline.diagram;

import dev.eventchain.check.ModelFiles;
import dev.eventchain.check.ReferenceFolders;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationResult;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.diagram.ChainLayout;
import dev.eventchain.model.diagram.DiagramSvg;
import dev.eventchain.model.diagram.PrintedSizes;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.pipeline.files.WrittenFiles;
import dev.eventchain.templates.ShippedTemplates;
import dev.eventchain.xmi.LoadedModel;
import dev.eventchain.xmi.Origins;
import dev.eventchain.xmi.XmiStore;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcorePackage;

/** Diagrams of models and metamodels, as PlantUML text and as an SVG picture. */
public final class Diagrams {

  /** Template set, with one template per kind of diagram. */
  private static final String TEMPLATES = "plantuml";

  /** Largest number of boxes and arrows in a diagram; larger ones are unreadable. */
  private static final int MOST = 1000;

  /** Time limit of a layout in processor time. Arrows between distant boxes take minutes. */
  private static final Duration LONGEST = Duration.ofSeconds(60);

  /** A line of PlantUML text for a box or an arrow. */
  private static final Pattern ITEM =
      Pattern.compile(
          "^((state|object|class|enum|interface|abstract) |\\S+ (\"[^\"]*\" )?\\S*(--|\\.\\.))",
          Pattern.MULTILINE);

  /** The kinds of diagrams. */
  public enum Kind {
    /** An event chain: its components in order, with the topics between them. */
    ACTIVITY,
    /** The elements of any model with their attributes and references. */
    INSTANCE,
    /** The classes of any Ecore metamodel. */
    METAMODEL;

    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  private final List<EPackage> metamodels = new ArrayList<>();
  private final List<EObject> roots = new ArrayList<>();
  private final Path source;
  private Origins origins = new Origins();

  private Diagrams(ModelFiles models) {
    List<Path> files =
        Stream.concat(models.files().stream(), models.metamodels().stream()).toList();
    ReferenceFolders references = models.references();
    XmiStore store = EventChainMetamodel.store(references.after(files), references.map());
    models.metamodels().forEach(ecore -> metamodels.addAll(store.loadMetamodel(ecore)));
    for (LoadedModel model : store.loadAll(models.files())) {
      roots.addAll(model.roots());
      origins = model.origins();
    }
    source = files.get(0);
    if (metamodels.isEmpty()) {
      metamodels.add(EventchainPackage.eINSTANCE);
    }
  }

  /**
   * Writes {@code KIND.puml} and {@code KIND.svg} for each kind.
   *
   * @param models the models to draw; without files if only metamodels are drawn
   * @param onEdit what becomes of files that a person has edited
   * @return the findings; a diagram with an error is not written, but the text of one that PlantUML
   *     cannot lay out
   * @throws DiagnosticException INPUT if a file cannot be read, or the output not written
   */
  public static WrittenFiles draw(Set<Kind> kinds, ModelFiles models, Path folder, OnEdit onEdit) {
    Diagrams diagrams = new Diagrams(models);
    WrittenFiles files = new WrittenFiles(Optional.of(folder));
    try (OutputFolder output = OutputFolder.open(folder)) {
      for (Kind kind : kinds) {
        List<Diagnostic> found = new ArrayList<>();
        Map<String, byte[]> drawn = diagrams.draw(kind, found);
        files.found(found);
        files.write(output, drawn, onEdit);
      }
    }
    return files;
  }

  private Map<String, byte[]> draw(Kind kind, List<Diagnostic> found) {
    List<? extends EObject> drawn = drawn(kind);
    if (drawn.isEmpty()) {
      found.add(nothing(kind));
      return Map.of();
    }
    TemplateModule module =
        TemplateModule.compile(
            ShippedTemplates.module(TEMPLATES, kind.toString()).orElseThrow(),
            ShippedTemplates.modules(TEMPLATES),
            List.of(EventchainPackage.eINSTANCE, EcorePackage.eINSTANCE));
    GenerationResult result = module.generate(drawn, context(kind));
    found.addAll(module.warnings());
    found.addAll(result.diagnostics());
    byte[] text = result.files().get(kind + ".puml");
    if (text == null || Diagnostic.anyError(result.diagnostics())) {
      return Map.of();
    }
    return withPicture(kind, drawn.get(0), text, found);
  }

  /** Returns the text and the picture of a diagram, as far as it can be drawn. */
  private Map<String, byte[]> withPicture(
      Kind kind, EObject first, byte[] text, List<Diagnostic> found) {
    String drawing = new String(text, StandardCharsets.UTF_8);
    long size = ITEM.matcher(drawing).results().count();
    try {
      Optional<byte[]> picture = size > MOST ? Optional.empty() : picture(kind, first, drawing);
      if (picture.isEmpty()) {
        found.add(tooLarge(kind, size));
        return Map.of();
      }
      return new TreeMap<>(Map.of(kind + ".puml", text, kind + ".svg", picture.get()));
    } catch (DiagramImage.UndrawableException e) {
      found.add(undrawn(kind));
      return Map.of(kind + ".puml", text);
    }
  }

  /** Draws a chain as reports and Eclipse do, and other models as PlantUML. */
  private static Optional<byte[]> picture(Kind kind, EObject drawn, String text) {
    if (kind != Kind.ACTIVITY) {
      return DiagramImage.svg(text, LONGEST);
    }
    PrintedSizes sizes = new PrintedSizes();
    String svg = DiagramSvg.of(ChainLayout.of((EventChain) drawn, sizes), sizes);
    return Optional.of(svg.getBytes(StandardCharsets.UTF_8));
  }

  private GenerationContext context(Kind kind) {
    String from =
        kind == Kind.METAMODEL
            ? metamodels.get(0).getNsURI()
            : String.valueOf(source.getFileName());
    return GenerationContext.of(origins::locate)
        .withProperties(
            Map.of(
                "provenance",
                "Made by Eventchain from " + from + " with templates/plantuml/" + kind + ".mtl"));
  }

  private List<? extends EObject> drawn(Kind kind) {
    return switch (kind) {
      case ACTIVITY ->
          roots.stream()
              .filter(root -> root instanceof EventChain chain && !chain.getSoftware().isEmpty())
              .limit(1)
              .toList();
      case INSTANCE -> roots;
      case METAMODEL -> metamodels;
    };
  }

  private Diagnostic nothing(Kind kind) {
    String what = kind == Kind.ACTIVITY ? "no event chain with a component" : "no element";
    return Diagnostic.of(
            DiagramRules.NOTHING,
            "There is nothing to draw: the model has " + what + ".",
            SourceLocation.of(source))
        .withHint("Draw a model of another metamodel with --kind instance.");
  }

  private Diagnostic undrawn(Kind kind) {
    return Diagnostic.of(
            DiagramRules.UNDRAWN,
            "PlantUML cannot lay out the %s diagram.".formatted(kind),
            SourceLocation.of(source))
        .withHint(
            "Draw its text, " + kind + ".puml, with another layout engine, such as Graphviz.");
  }

  private Diagnostic tooLarge(Kind kind, long size) {
    String problem =
        size > MOST
            ? "at most " + MOST + " are drawn"
            : "their layout takes more than " + LONGEST.toSeconds() + " s of processor time";
    return Diagnostic.of(
            DiagramRules.TOO_LARGE,
            String.format(
                Locale.ROOT, "The %s diagram has %d boxes and arrows; %s.", kind, size, problem),
            SourceLocation.of(source))
        .withHint(
            kind == Kind.INSTANCE
                ? "Draw a smaller model, or an event chain with --kind activity."
                : "Draw a part of it.");
  }
}
