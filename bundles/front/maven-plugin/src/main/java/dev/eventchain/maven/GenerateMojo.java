package dev.eventchain.maven;

import dev.eventchain.check.ModelFiles;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.pipeline.AnyModel;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.files.WrittenFiles;
import dev.eventchain.pipeline.run.Stage;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.apache.maven.model.Resource;
import org.apache.maven.plugins.annotations.LifecyclePhase;
import org.apache.maven.plugins.annotations.Mojo;
import org.apache.maven.plugins.annotations.Parameter;

/**
 * Generates text from models of any Ecore metamodel by a template, or the package of an event
 * chain. Keeps files that are up to date; deletes files that an earlier run of the execution
 * generated and that are no longer generated.
 */
@Mojo(name = "generate", defaultPhase = LifecyclePhase.GENERATE_SOURCES, threadSafe = true)
public final class GenerateMojo extends ModelMojo {

  /** Uses of the generated files in the module. */
  enum Use {
    /** Sources for the compiler. */
    SOURCES,
    /** Resources for the module's jar. */
    RESOURCES,
    /** Neither sources nor resources. */
    NONE
  }

  /** The template's main module; without it, the package of an event chain is generated. */
  @Parameter(property = "eventchain.template")
  private File template;

  /** Source roots of the template: {@code [import a::b]} is {@code a/b.mtl} in one of them. */
  @Parameter private List<File> sources = List.of();

  /** Jars and folders of classes that the template may call with {@code invoke(...)}. */
  @Parameter private List<File> services = List.of();

  /** Properties files that {@code getProperty('key')} reads, in this order. */
  @Parameter private List<File> properties = List.of();

  /** True to write {@code trace.json}, which maps each line to its template line and element. */
  @Parameter(property = "eventchain.trace", defaultValue = "false")
  private boolean trace;

  /**
   * True to report undefined values, values that the metamodel forbids or misses, and files that
   * another block overwrites, as warnings.
   */
  @Parameter(property = "eventchain.lenient", defaultValue = "false")
  private boolean lenient;

  /** The folder for the files that a template writes. */
  @Parameter(defaultValue = "${project.build.directory}/generated-sources/eventchain")
  private File outputDirectory;

  /**
   * Use of the generated files in the module: {@code SOURCES}, {@code RESOURCES} or {@code NONE}.
   */
  @Parameter(property = "eventchain.use", defaultValue = "SOURCES")
  private Use use;

  @Override
  Outcome work() {
    Optional<Path> chain = chain();
    if (template == null && chain.isPresent()) {
      return run(chain.get(), Stage.GENERATE);
    }
    if (template == null || !hasModels()) {
      String message =
          template == null ? "There is no template and no event chain." : "There is no model.";
      return nothing(List.of(NothingToDo.finding(message, Optional.of(basedir()))));
    }
    return nothingIn().orElseGet(this::generate);
  }

  private Outcome generate() {
    Suppressions suppressions = suppressions();
    WrittenFiles files =
        AnyModel.generate(
            new ModelFiles(models(), metamodels(), references()),
            new AnyModel.Template(
                Places.shown(template),
                Places.shown(sources),
                Places.shown(services),
                Places.shown(properties)),
            new AnyModel.Target(
                Optional.of(Places.shown(outputDirectory)), onEdit(), trace, Optional.of(name())),
            new AnyModel.Check(lenient, suppressions, timeLimit()));
    if (!files.printed().isEmpty()) {
      files.printed().lines().forEach(getLog()::info);
    }
    addToModule();
    return Outcome.of(files, suppressions);
  }

  private void addToModule() {
    String folder = outputDirectory.getAbsolutePath();
    if (use == Use.SOURCES) {
      project().addCompileSourceRoot(folder);
    } else if (use == Use.RESOURCES) {
      Resource resource = new Resource();
      resource.setDirectory(folder);
      resource.addExclude(".eventchain/**");
      project().addResource(resource);
    }
  }
}
