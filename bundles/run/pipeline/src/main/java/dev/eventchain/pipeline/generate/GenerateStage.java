package dev.eventchain.pipeline.generate;

import dev.eventchain.check.ChainChecks;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationResult;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.project.Templates;
import dev.eventchain.pipeline.stage.ChainSnapshot;
import dev.eventchain.pipeline.stage.ComponentFiles;
import dev.eventchain.pipeline.stage.ComponentSources;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.HelperModules;
import dev.eventchain.pipeline.stage.ProjectChecks;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageResult;
import dev.eventchain.pipeline.stage.StageWork;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.SoftwareBase;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;

/** Generates the middleware package from the model: nodes by templates, with the components. */
public final class GenerateStage implements StageWork {

  @Override
  public void fingerprint(RunContext run, Fingerprint fingerprint) {
    fingerprint
        .addSetting("template", run.project().configuration().template())
        .addFile(run.model())
        .addFiles(run.project().signalFiles())
        .addNode()
        .addMessages()
        .addFile(run.file(ProjectFolder.GENERATED));
    run.project().configuration().packageFacts().forEach(fingerprint::addSetting);
    fingerprint.addFiles(run.project().ownConstraints());
    fingerprint.addFiles(
        run.softwareBase().components().stream().map(SoftwareBase.Component::file).toList());
    fingerprint.addFiles(HostedNodes.copies(run).values());
    fingerprint.addFiles(ComponentSources.helpers(run, run.chain().chain()).files().values());
    for (SoftwareNode node : run.chain().chain().getSoftware()) {
      fingerprint.addFile(run.file(ComponentFiles.name(node.getName())));
    }
    fingerprint.addFiles(Templates.ownFiles(run.project()));
  }

  @Override
  public StageResult execute(RunContext run) {
    ChainSnapshot model = run.chain();
    // An invalid model must not be turned into software.
    ChainChecks.Outcome checked = model.checks();
    ProjectChecks.refuseErrors(run, checked);
    String folder = Templates.folder(run.project());
    TemplateModule module =
        Templates.compile(
            run.project(), List.of(EventchainPackage.eINSTANCE, MessageModel.metamodel()));
    HelperModules helpers = ComponentSources.helpers(run, model.chain());
    ComponentImports imports = imports(run, model.chain(), helpers);
    GenerationResult generated = generate(run, module, properties(run, imports, helpers));
    List<Diagnostic> found = new ArrayList<>(module.warnings());
    found.addAll(imports.unknown());
    found.addAll(findings(generated));
    if (Diagnostic.anyError(found)) {
      throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, found);
    }
    SortedMap<String, byte[]> files = within(folder, generated);
    found.addAll(UnitConversions.check(model, GeneratedPackage.among(run, files)));
    // Errors among them are suppressed, for as long as the suppressions are valid.
    found.addAll(checked.diagnostics());
    String written = components(run, model.chain(), helpers, folder, files);
    files.forEach(run::write);
    run.writeResult(
        TraceFile.NAME, TraceFile.content(generated.trace(), folder + "/", run.baseFolders()));
    found.addAll(run.output().removeOthers(folder, files.keySet()));
    return StageResult.of(files.size() + " files in " + written, outputs(files), found);
  }

  private static List<String> outputs(SortedMap<String, byte[]> files) {
    return Stream.concat(files.keySet().stream(), Stream.of(TraceFile.NAME)).toList();
  }

  /** Returns generated files by their names in the output folder. */
  private static SortedMap<String, byte[]> within(String folder, GenerationResult generated) {
    SortedMap<String, byte[]> files = new TreeMap<>(OutputFolder.WRITING_ORDER);
    generated.files().forEach((file, content) -> files.put(folder + "/" + file, content));
    return files;
  }

  private static List<Diagnostic> findings(GenerationResult generated) {
    Stream<Diagnostic> lost = generated.printed().stream().map(GenerateStage::lost).distinct();
    List<Diagnostic> found =
        Diagnostic.anyError(generated.diagnostics())
            ? generated.diagnosticsIfUnwritten()
            : generated.diagnostics();
    return Stream.concat(found.stream(), lost).toList();
  }

  private static Diagnostic lost(GenerationResult.Printed printed) {
    return Diagnostic.of(
            GenerateRules.TEMPLATE_PRINTED,
            "The text that this block prints is lost: a stage has no standard output.",
            printed.block())
        .withHint("Write a file, or leave the block out of the templates of the project.");
  }

  private static GenerationResult generate(
      RunContext run, TemplateModule module, Map<String, String> properties) {
    ChainSnapshot model = run.chain();
    String folder = Templates.folder(run.project());
    return module.generate(
        List.of(model.chain(), MessageModel.of(model.chain(), run.messages())),
        GenerationContext.of(model::locate)
            .withEarlier(name -> run.output().read(folder + "/" + name))
            .withProperties(properties)
            .withTrace());
  }

  /** Returns the template properties for the head of generated files and the package's metadata. */
  private static Map<String, String> properties(
      RunContext run, ComponentImports imports, HelperModules helpers) {
    String version = GenerateStage.class.getPackage().getImplementationVersion();
    Map<String, String> properties = new TreeMap<>(run.project().configuration().packageFacts());
    properties.put("provenance.model", run.model().getFileName().toString());
    properties.put("package.nodes", HostedNodes.entries(run));
    properties.put("package.helpers", String.join(" ", helpers.files().keySet()));
    properties.put("package.rosdep", String.join(" ", imports.rosdepKeys()));
    properties.put("package.pip", String.join(" ", imports.pipNames()));
    properties.putAll(UnitConversions.properties(run.chain().chain()));
    if (version != null) {
      properties.put("provenance.version", version);
    }
    return properties;
  }

  private static ComponentImports imports(RunContext run, EventChain chain, HelperModules helpers) {
    boolean pip = Templates.installsWithPip(run.project());
    ComponentImports imports = new ComponentImports(run.messages(), pip, helpers.files().keySet());
    for (SoftwareNode node : chain.getSoftware()) {
      if (node.getImplementation() == ComponentImplementation.COMPONENT) {
        String name = "The component '" + node.getName() + "'";
        imports.add(name, SourceText.read(ComponentFiles.of(run, node)));
      }
    }
    helpers
        .files()
        .forEach((name, file) -> imports.add("The module '" + name + "'", SourceText.read(file)));
    return imports;
  }

  /**
   * Copies the components, and the modules that they import, to the folder in the manifest of the
   * generated files; without a manifest, as with templates of a project, into a package named after
   * the chain.
   *
   * @return the folder of the package
   */
  private static String components(
      RunContext run,
      EventChain chain,
      HelperModules helpers,
      String folder,
      SortedMap<String, byte[]> files) {
    Optional<GeneratedPackage> generated = GeneratedPackage.among(run, files);
    String name = chain.getName().toLowerCase(Locale.ROOT);
    for (SoftwareNode node : chain.getSoftware()) {
      if (node.getImplementation() == ComponentImplementation.COMPONENT) {
        String unstated =
            folder + "/" + name + "/" + name + "/" + ComponentFiles.name(node.getName());
        String file = generated.map(found -> found.componentFile(node)).orElse(unstated);
        files.put(file, content(ComponentFiles.of(run, node)));
        for (var helper : helpers.files().entrySet()) {
          files.put(GeneratedPackage.besides(file, helper.getKey()), content(helper.getValue()));
        }
      }
    }
    String written = generated.map(GeneratedPackage::folder).orElse(folder + "/" + name);
    HostedNodes.copies(run).forEach((copy, file) -> files.put(written + "/" + copy, content(file)));
    return written;
  }

  private static byte[] content(Path file) {
    return SourceText.read(file).text().getBytes(StandardCharsets.UTF_8);
  }
}
