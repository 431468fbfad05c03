package dev.eventchain.pipeline;

import dev.eventchain.check.ModelFiles;
import dev.eventchain.check.ModelValidation;
import dev.eventchain.check.ReferenceFolders;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationContext.Trait;
import dev.eventchain.m2t.generation.GenerationResult;
import dev.eventchain.m2t.generation.GenerationRules;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.output.OutputPath;
import dev.eventchain.output.OutputRules;
import dev.eventchain.pipeline.files.WrittenFiles;
import dev.eventchain.pipeline.generate.MessageModel;
import dev.eventchain.pipeline.generate.TraceFile;
import dev.eventchain.pipeline.project.Templates;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.templates.ShippedTemplates;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.EnumSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.eclipse.emf.ecore.EPackage;

/** Generation from models of any Ecore metamodel, without a project. */
public final class AnyModel {

  /**
   * The check of models before text is generated from them.
   *
   * @param lenient true to report errors after which Acceleo continues as warnings
   * @param suppressions the suppressed findings about the models
   * @param timeLimit the processor time that the patterns of a data type may take
   */
  public record Check(boolean lenient, Suppressions suppressions, Duration timeLimit) {

    private List<Diagnostic> of(List<Diagnostic> found) {
      return lenient ? milder(found) : found;
    }
  }

  /**
   * A template outside of projects, with its dependencies.
   *
   * @param main the main module, or the name of a shipped template about chains: {@code nodl}
   * @param sources the source roots of its modules; its own folders need not be named
   * @param services JARs and folders of classes whose methods the templates may call
   * @param properties properties files; the first one with a key takes precedence
   */
  public record Template(
      Path main, List<Path> sources, List<Path> services, List<Path> properties) {

    /** Copies the lists. */
    public Template {
      sources = List.copyOf(sources);
      services = List.copyOf(services);
      properties = List.copyOf(properties);
    }
  }

  /**
   * The target of generated text.
   *
   * @param folder the output folder; without one, a block that writes a file is an error, and only
   *     printed text is returned
   * @param onEdit what becomes of files that a person has edited
   * @param trace true to write {@code trace.json}, too, which gives the origin of each line
   * @param producer the identifier of this generation among others into the same folder; files that
   *     its previous run wrote, and this one does not, are removed. Without it, they stay
   * @param refused the names that no written file and no folder of one may have, in any case of
   *     letters; {@code *} stands for any characters
   */
  public record Target(
      Optional<Path> folder,
      OnEdit onEdit,
      boolean trace,
      Optional<String> producer,
      List<String> refused) {

    /** Copies the list. */
    public Target {
      refused = List.copyOf(refused);
    }

    /** A target in which files may have any names. */
    public Target(Optional<Path> folder, OnEdit onEdit, boolean trace, Optional<String> producer) {
      this(folder, onEdit, trace, producer, List.of());
    }

    /** Returns a finding for each file whose name is refused. */
    private List<Diagnostic> refusals(Collection<String> files) {
      List<Pattern> patterns = refused.stream().map(Target::pattern).toList();
      return files.stream()
          .filter(
              file ->
                  Arrays.stream(file.split("/"))
                      .anyMatch(
                          part -> patterns.stream().anyMatch(it -> it.matcher(part).matches())))
          .map(Target::refusal)
          .toList();
    }

    private static Pattern pattern(String name) {
      String regex = Pattern.quote(name).replace("*", "\\E.*\\Q");
      return Pattern.compile(regex, Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CASE);
    }

    private static Diagnostic refusal(String file) {
      return Diagnostic.of(
              OutputRules.OUTPUT_PATH_REFUSED,
              "The file name '" + OutputPath.shown(file) + "' is refused here.",
              SourceLocation.NONE)
          .withHint("Let the template write a file of another name.");
    }
  }

  private AnyModel() {}

  /**
   * Generates text from models.
   *
   * @param models those on whose elements the template runs; it also sees those that they refer to
   * @param template with its modules, services and properties
   * @param target the output
   * @return the findings; nothing is written if one of them is an error other than an undefined
   *     value, for example if a model breaks a rule of its metamodel and the check is not lenient
   * @throws DiagnosticException INPUT if a file cannot be read, or the output not written
   */
  public static WrittenFiles generate(
      ModelFiles models, Template template, Target target, Check check) {
    ModelValidation any = ModelValidation.read(models, check.timeLimit());
    Map<String, Map<String, String>> properties = PropertyFiles.read(template.properties());
    try (JavaServices classes = JavaServices.of(template.services())) {
      TemplateModule module =
          new ProfilesBeside(models.references())
              .compile(
                  template,
                  withMessages(any.packages()),
                  packages -> module(template, packages, classes.loader()));
      WrittenFiles files = new WrittenFiles(target.folder());
      files.found(check.of(any.ecore().diagnostics()));
      if (!Diagnostic.anyError(check.suppressions().part(files.diagnostics()).remaining())) {
        GenerationContext context =
            GenerationContext.of(any::locate)
                .withPropertyFiles(properties)
                .with(traits(target, check.lenient()));
        if (target.folder().isEmpty()) {
          files.found(generate(any, module, context, files).diagnostics());
        } else {
          write(any, module, context, files, target);
        }
      } else if (target.folder().isPresent()) {
        files.wroteNothing();
      }
      return files;
    }
  }

  /**
   * Compiles templates, without a model and without running them.
   *
   * @param metamodels the metamodels that the templates name; event chains, UML, and profiles of
   *     UML in the folders of the templates need not be named
   * @param references as of {@link ModelFiles}
   * @param templates each with its modules and services
   * @return the findings, each once
   * @throws DiagnosticException INPUT if a metamodel cannot be read, or a template is not there
   */
  public static List<Diagnostic> compile(
      List<Path> metamodels, ReferenceFolders references, List<Template> templates) {
    List<EPackage> packages = withMessages(ModelValidation.metamodels(metamodels, references));
    ProfilesBeside profiles = new ProfilesBeside(references);
    Set<Diagnostic> found = new LinkedHashSet<>();
    boolean missing = false;
    for (Template template : templates) {
      try (JavaServices classes = JavaServices.of(template.services())) {
        found.addAll(
            profiles
                .compile(template, packages, all -> compiled(template, all, classes.loader()))
                .warnings());
      } catch (DiagnosticException e) {
        missing |= !Files.isRegularFile(template.main());
        found.addAll(e.diagnostics());
      }
    }
    if (missing) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, List.copyOf(found));
    }
    return List.copyOf(found);
  }

  /**
   * Returns the packages, classes, features and operations of metamodels as text.
   *
   * @param metamodels the files; none for the metamodel of event chains
   * @throws DiagnosticException INPUT if a file cannot be read
   */
  public static String describe(List<Path> metamodels, ReferenceFolders references) {
    return MetamodelListing.of(
        ModelValidation.metamodels(metamodels, references).stream()
            .filter(each -> each.getESuperPackage() == null)
            .filter(each -> metamodels.isEmpty() || !(each instanceof EventchainPackage))
            .toList());
  }

  /** Compiles a template: one that ships with the program, if it is named instead of a file. */
  private static TemplateModule module(
      Template template, List<EPackage> packages, Optional<ClassLoader> services) {
    String name = template.main().toString();
    return ShippedTemplates.isFormat(name) && !Files.exists(template.main())
        ? Templates.shipped(name, "main", packages)
        : TemplateModule.compile(template.main(), template.sources(), packages, services);
  }

  /** Compiles a template; one of a project may import the shipped modules, as in its stages. */
  private static TemplateModule compiled(
      Template template, List<EPackage> packages, Optional<ClassLoader> services) {
    boolean alone = template.sources().isEmpty() && template.services().isEmpty();
    return alone && ProjectFolder.around(template.main()).isPresent()
        ? TemplateModule.compile(
            template.main(), ShippedTemplates.modules(ShippedTemplates.DEFAULT), packages)
        : TemplateModule.compile(template.main(), template.sources(), packages, services);
  }

  /** Returns findings with warnings in place of errors that Acceleo does not look for. */
  private static List<Diagnostic> milder(List<Diagnostic> found) {
    return found.stream()
        .map(each -> each.severity() == Severity.ERROR ? each.withSeverity(Severity.WARNING) : each)
        .toList();
  }

  /**
   * Returns the packages for templates, which may use message definitions: without a project there
   * are none.
   */
  private static List<EPackage> withMessages(List<EPackage> packages) {
    List<EPackage> all = new ArrayList<>(packages);
    EPackage messages = MessageModel.metamodel();
    if (all.stream().noneMatch(given -> messages.getNsURI().equals(given.getNsURI()))) {
      all.add(messages);
    }
    return all;
  }

  private static Set<Trait> traits(Target target, boolean lenient) {
    Set<Trait> traits = EnumSet.noneOf(Trait.class);
    if (target.folder().isEmpty()) {
      traits.add(Trait.PRINTED_ONLY);
    }
    if (target.trace()) {
      traits.add(Trait.TRACED);
    }
    if (lenient) {
      traits.add(Trait.LENIENT);
    }
    return traits;
  }

  private static GenerationResult generate(
      ModelValidation any, TemplateModule module, GenerationContext context, WrittenFiles files) {
    GenerationResult result = module.generate(any.roots(), context);
    files.found(module.warnings());
    files.print(result.printedText());
    return result;
  }

  private static void write(
      ModelValidation any,
      TemplateModule module,
      GenerationContext context,
      WrittenFiles files,
      Target target) {
    try (OutputFolder output = OutputFolder.open(target.folder().orElseThrow())) {
      GenerationResult result = generate(any, module, context.withEarlier(output::read), files);
      boolean taken = target.trace() && result.files().containsKey(TraceFile.NAME);
      List<Diagnostic> refusals = target.refusals(result.files().keySet());
      if (taken || !refusals.isEmpty() || !result.isWhole()) {
        files.found(result.diagnosticsIfUnwritten());
        files.found(refusals);
        files.found(taken ? List.of(traceTaken()) : List.of());
        files.wroteNothing();
        return;
      }
      files.found(result.diagnostics());
      files.write(output, result.files(), target.onEdit());
      Set<String> produced = new TreeSet<>(result.files().keySet());
      if (target.trace()) {
        byte[] content = TraceFile.content(result.trace(), "", List.of());
        files.write(output, Map.of(TraceFile.NAME, content), OnEdit.OVERWRITE);
        produced.add(TraceFile.NAME);
      }
      target.producer().map(name -> output.removeFormer(name, produced)).ifPresent(files::found);
    }
  }

  private static Diagnostic traceTaken() {
    return Diagnostic.of(
            GenerationRules.FILE_DUPLICATE,
            "A template writes the file '" + TraceFile.NAME + "', which is the name of the trace.",
            SourceLocation.of(TraceFile.NAME))
        .withHint("Give the file another name, or leave out --trace.");
  }
}
