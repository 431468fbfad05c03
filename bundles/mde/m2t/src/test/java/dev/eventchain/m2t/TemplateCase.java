package dev.eventchain.m2t;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationResult;
import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.resource.ResourceSet;
import org.eclipse.emf.ecore.resource.impl.ResourceSetImpl;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.emf.ecore.xmi.impl.EcoreResourceFactoryImpl;
import org.eclipse.emf.ecore.xmi.impl.XMIResourceFactoryImpl;

/**
 * A template, a metamodel ({@code *.ecore}) and a model ({@code model.xmi}) in a folder; missing
 * ones of the last two are looked up in the enclosing folders. Instead of a template there may be a
 * {@code links.properties} with the comma-separated paths of the {@code template} and the {@code
 * metamodel}s in the repository. Files of an earlier run may be in {@code earlier/}. The templates
 * may call {@link CaseServices}, and read {@code texts.properties} and the properties of the
 * generation, to which {@code generation.properties} adds some.
 */
record TemplateCase(Path folder) {
  private static final String TEXTS = "texts.properties";

  /** Result of a case: files, and findings one per line. */
  record Outcome(SortedMap<String, byte[]> files, String findings) {}

  /** A compiled template, its model, and the context of a generation. */
  record Prepared(TemplateModule module, Resource model, GenerationContext context) {
    GenerationResult generate(UnaryOperator<GenerationContext> changed) {
      return ShallowStack.generate(module, model.getContents(), changed.apply(context));
    }
  }

  Outcome run() throws IOException {
    try {
      Prepared prepared = prepare();
      GenerationResult result = prepared.generate(UnaryOperator.identity());
      List<Diagnostic> findings = new ArrayList<>(prepared.module().warnings());
      findings.addAll(result.diagnostics());
      return new Outcome(result.files(), text(findings));
    } catch (DiagnosticException e) {
      return new Outcome(new TreeMap<>(), text(e.diagnostics()));
    }
  }

  /**
   * Loads and compiles.
   *
   * @throws DiagnosticException if the template is invalid
   */
  Prepared prepare() throws IOException {
    ResourceSet resources = new ResourceSetImpl();
    Map<String, Object> factories =
        resources.getResourceFactoryRegistry().getExtensionToFactoryMap();
    factories.put("ecore", new EcoreResourceFactoryImpl());
    factories.put("*", new XMIResourceFactoryImpl());
    List<EPackage> packages = metamodels(resources);
    Resource model = resources.getResource(uri(nearest("model.xmi")), true);
    EcoreUtil.resolveAll(model);
    return new Prepared(compile(packages), model, context());
  }

  static boolean isCase(Path folder) {
    return Files.exists(folder.resolve("template.mtl"))
        || Files.exists(folder.resolve("links.properties"));
  }

  private TemplateModule compile(List<EPackage> packages) throws IOException {
    List<Path> linked = linked("template");
    Optional<ClassLoader> services = Optional.of(CaseServices.class.getClassLoader());
    return !linked.isEmpty()
        ? TemplateModule.compile(linked.get(0), List.of(), packages, services)
        : TemplateModule.compile(source("template"), this::find, packages, services);
  }

  /** Returns linked files of the repository. */
  private List<Path> linked(String what) throws IOException {
    Path links = folder.resolve("links.properties");
    if (!Files.exists(links)) {
      return List.of();
    }
    Properties properties = new Properties();
    try (Reader reader = Files.newBufferedReader(links)) {
      properties.load(reader);
    }
    return Arrays.stream(properties.getProperty(what, "").split(" *, *"))
        .filter(name -> !name.isEmpty())
        .map(name -> Path.of("../../..").resolve(name))
        .toList();
  }

  private GenerationContext context() {
    Function<EObject, SourceLocation> locator =
        object -> SourceLocation.of("model.xmi").withElement(EcoreUtil.getURI(object).fragment());
    return GenerationContext.of(locator)
        .withEarlier(this::earlier)
        .withProperties(properties())
        .withPropertyFiles(propertyFiles());
  }

  /** Returns the properties of each generation, and those of {@code generation.properties}. */
  private Map<String, String> properties() {
    Map<String, String> properties = new TreeMap<>(texts(folder.resolve("generation.properties")));
    properties.put("greeting", "hello");
    properties.put("provenance.version", "1.0");
    properties.put("provenance.model", "model.xmi");
    return properties;
  }

  /** Returns the properties of {@code texts.properties}, if the case has one. */
  private Map<String, Map<String, String>> propertyFiles() {
    Path file = folder.resolve(TEXTS);
    return Files.exists(file) ? Map.of(TEXTS, texts(file)) : Map.of();
  }

  private static Map<String, String> texts(Path file) {
    if (!Files.exists(file)) {
      return Map.of();
    }
    Properties read = new Properties();
    try (Reader reader = Files.newBufferedReader(file)) {
      read.load(reader);
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
    Map<String, String> texts = new TreeMap<>();
    read.forEach((key, value) -> texts.put((String) key, (String) value));
    return texts;
  }

  private Optional<byte[]> earlier(String name) {
    try {
      Path file = folder.resolve("earlier").resolve(name);
      return Files.exists(file) ? Optional.of(Files.readAllBytes(file)) : Optional.empty();
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  private List<EPackage> metamodels(ResourceSet resources) throws IOException {
    List<Path> linked = linked("metamodel");
    if (!linked.isEmpty()) {
      return linked.stream().map(file -> metamodel(resources, file)).toList();
    }
    for (Path place = folder; place != null; place = place.getParent()) {
      try (var files = Files.list(place)) {
        List<Path> ecores = files.filter(f -> f.toString().endsWith(".ecore")).sorted().toList();
        if (!ecores.isEmpty()) {
          return ecores.stream().map(f -> metamodel(resources, f)).toList();
        }
      }
    }
    throw new IOException("no metamodel for " + folder);
  }

  private static EPackage metamodel(ResourceSet resources, Path file) {
    EPackage metamodel = (EPackage) resources.getResource(uri(file), true).getContents().get(0);
    resources.getPackageRegistry().put(metamodel.getNsURI(), metamodel);
    return metamodel;
  }

  private Path nearest(String name) throws IOException {
    for (Path place = folder; place != null; place = place.getParent()) {
      if (Files.exists(place.resolve(name))) {
        return place.resolve(name);
      }
    }
    throw new IOException("no " + name + " for " + folder);
  }

  private Optional<SourceText> find(String module) {
    String path = module.replace("::", "/");
    return Files.exists(folder.resolve(path + ".mtl"))
        ? Optional.of(source(path))
        : Optional.empty();
  }

  private SourceText source(String module) {
    SourceText read = SourceText.read(folder.resolve(module + ".mtl"));
    return SourceText.of(module + ".mtl", read.text());
  }

  private static URI uri(Path file) {
    return URI.createFileURI(file.toAbsolutePath().toString());
  }

  static String text(List<Diagnostic> findings) {
    StringBuilder text = new StringBuilder();
    for (Diagnostic finding : findings) {
      SourceLocation place = finding.location();
      text.append(place).append(place.element().isEmpty() ? "" : " [" + place.element() + "]");
      text.append(' ').append(finding.severity().name().toLowerCase(Locale.ROOT)).append(' ');
      text.append(finding.id()).append(": ").append(finding.message());
      text.append(finding.hint().isEmpty() ? "" : " > " + finding.hint()).append('\n');
    }
    return text.toString();
  }
}
