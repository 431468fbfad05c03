package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.m2t.GenerationContext;
import dev.eventchain.m2t.GenerationContext.Trait;
import dev.eventchain.m2t.GenerationResult;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.validation.ModelValidation;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EPackage;

/** Generation from models of any Ecore metamodel, without a project. */
public final class AnyModel {

  /**
   * A template that is in no project, and what it needs.
   *
   * @param main the main module
   * @param sources the source roots of its modules; folders that it is in need not be named
   * @param services JARs and folders of classes whose methods the templates may call
   * @param properties files of properties; where several have a key, the first one counts
   */
  public record Template(
      Path main, List<Path> sources, List<Path> services, List<Path> properties) {

    /** Keeps the lists from changing. */
    public Template {
      sources = List.copyOf(sources);
      services = List.copyOf(services);
      properties = List.copyOf(properties);
    }
  }

  private AnyModel() {}

  /**
   * Generates text from models.
   *
   * @param map the folders that beginnings of references stand for: {@code platform:/resource/}
   * @param template with its modules, services and properties
   * @param models the template runs on the elements of each of them, and sees those that they refer
   *     to in other files
   * @param folder where the files go; without one, a block that writes a file is an error, and what
   *     others print is all there is
   * @param overwrite whether files that a person has edited are replaced
   * @param trace whether {@code trace.json} is written, too, which says where each line comes from
   * @param lenient whether what Acceleo continues after without failing is a warning
   * @param suppressions what is wrong with the models and is not to count
   * @param timeLimit the processor time that the patterns of a data type may take
   * @return what was found, and nothing written if one of it is an error, other than that values
   *     are undefined: also where a model is not an instance of its metamodel
   * @throws DiagnosticException INPUT if a file cannot be read, or the output not written
   */
  public static WrittenFiles generate(
      List<Path> metamodels,
      Map<String, Path> map,
      Template template,
      List<Path> models,
      Optional<Path> folder,
      boolean overwrite,
      boolean trace,
      boolean lenient,
      Suppressions suppressions,
      Duration timeLimit) {
    ModelValidation any = ModelValidation.read(metamodels, map, models, timeLimit);
    Map<String, Map<String, String>> properties = PropertyFiles.read(template.properties());
    try (JavaServices classes = JavaServices.of(template.services())) {
      TemplateModule module =
          TemplateModule.compile(
              template.main(), template.sources(), templatePackages(any), classes.loader());
      WrittenFiles files = new WrittenFiles(folder);
      files.found(any.ecore().diagnostics());
      if (!Diagnostic.anyError(suppressions.part(files.diagnostics()).remaining())) {
        GenerationContext context =
            GenerationContext.of(any::locate)
                .withPropertyFiles(properties)
                .with(traits(folder.isEmpty(), trace, lenient));
        if (folder.isEmpty()) {
          generate(any, module, context, files);
        } else {
          write(any, module, context, files, folder.get(), overwrite);
        }
      }
      return files;
    }
  }

  /**
   * Templates may be written for definitions of messages, too: without a project there are none.
   */
  private static List<EPackage> templatePackages(ModelValidation any) {
    List<EPackage> all = new ArrayList<>(any.packages());
    EPackage messages = MessageModel.metamodel();
    if (all.stream().noneMatch(given -> messages.getNsURI().equals(given.getNsURI()))) {
      all.add(messages);
    }
    return all;
  }

  private static Set<Trait> traits(boolean printed, boolean trace, boolean lenient) {
    Set<Trait> traits = EnumSet.noneOf(Trait.class);
    if (printed) {
      traits.add(Trait.PRINTED_ONLY);
    }
    if (trace) {
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
    files.found(result.diagnostics());
    files.print(result.printedText());
    return result;
  }

  private static void write(
      ModelValidation any,
      TemplateModule module,
      GenerationContext context,
      WrittenFiles files,
      Path folder,
      boolean overwrite) {
    try (OutputFolder output = OutputFolder.open(folder)) {
      GenerationResult result = generate(any, module, context.withEarlier(output::read), files);
      boolean trace = context.traits().contains(Trait.TRACED);
      boolean taken = trace && result.files().containsKey(TraceFile.NAME);
      if (taken) {
        files.found(List.of(traceTaken()));
      }
      if (taken || !result.isWhole()) {
        return;
      }
      files.write(output, result.files(), overwrite ? OnEdit.OVERWRITE : OnEdit.KEEP);
      if (trace) {
        byte[] content = TraceFile.content(result.trace(), "", List.of());
        files.write(output, Map.of(TraceFile.NAME, content), OnEdit.OVERWRITE);
      }
    }
  }

  private static Diagnostic traceTaken() {
    return Diagnostic.error(
            "m2t.file.duplicate",
            "A template writes the file '" + TraceFile.NAME + "', which the trace goes into.",
            SourceLocation.of(TraceFile.NAME))
        .withHint("Give the file another name, or leave out --trace.");
  }
}
