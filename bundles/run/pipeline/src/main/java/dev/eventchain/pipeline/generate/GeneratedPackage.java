package dev.eventchain.pipeline.generate;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.project.Templates;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.simulation.node.NodeManifest;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The package generated for a chain, according to its manifest.
 *
 * @param folder the folder of the manifest, relative to the output folder
 */
public record GeneratedPackage(String folder, NodeManifest manifest) {

  /**
   * Finds the manifest among generated files.
   *
   * @param files the contents by names relative to the output folder
   * @return empty if there is none, as with templates that write none
   * @throws DiagnosticException INPUT, {@code simulation.manifest}, if there are several or it is
   *     wrong
   */
  static Optional<GeneratedPackage> among(RunContext run, Map<String, byte[]> files) {
    return single(run, List.copyOf(files.keySet()))
        .map(
            name -> {
              String text = new String(files.get(name), StandardCharsets.UTF_8);
              return of(name, SourceText.of(SourceLocation.of(run.file(name)).file(), text));
            });
  }

  /**
   * Reads the manifest of the generated package.
   *
   * @throws DiagnosticException INPUT: {@code project.stage.missing} if nothing was generated,
   *     {@code simulation.manifest} if there is no manifest, several, or a wrong one
   */
  public static GeneratedPackage required(RunContext run) {
    String folder = Templates.folder(run.project());
    Path all = run.file(folder);
    List<Path> files = Files.isDirectory(all) ? ProjectFolder.below(all) : List.of();
    Optional<String> found =
        single(run, files.stream().map(file -> folder + "/" + name(all, file)).toList());
    if (found.isEmpty()) {
      Optional<Path> template = Templates.own(run.project());
      if (template.isPresent() && !files.isEmpty()) {
        throw unmanaged(template.get());
      }
      run.required(folder, Stage.GENERATE);
    }
    String name = found.orElseThrow();
    return of(name, SourceText.read(run.file(name)));
  }

  private static String name(Path folder, Path file) {
    return folder.relativize(file).toString().replace('\\', '/');
  }

  private static Optional<String> single(RunContext run, List<String> files) {
    List<String> found =
        files.stream().filter(file -> file.endsWith("/" + NodeManifest.FILE)).toList();
    if (found.size() > 1) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  NodeManifest.ID,
                  "There are several manifests: " + String.join(", ", found) + ".",
                  SourceLocation.of(run.file(found.get(1))))
              .withHint(
                  "Let the template write only one, and delete those left from earlier runs."));
    }
    return found.stream().findFirst();
  }

  private static GeneratedPackage of(String name, SourceText text) {
    return new GeneratedPackage(name.substring(0, name.lastIndexOf('/')), NodeManifest.read(text));
  }

  private static DiagnosticException unmanaged(Path template) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(
                NodeManifest.ID,
                "The template writes no "
                    + NodeManifest.FILE
                    + ", so the nodes to simulate are not known.",
                SourceLocation.of(template))
            .withHint(
                "Import python::manifest and call [chain.manifestFile()/] where names are those of"
                    + " the shipped sets, or ros2_python::main and call [chain.main()/] for the"
                    + " whole package."));
  }

  /** Returns the file of a module beside a component's file, by the module's name. */
  public static String besides(String componentFile, String module) {
    return componentFile.substring(0, componentFile.lastIndexOf('/') + 1) + module + ".py";
  }

  /**
   * Returns the file of a component, relative to the output folder.
   *
   * @throws DiagnosticException INPUT, {@code simulation.manifest}, if the manifest does not name
   *     it
   */
  public String componentFile(SoftwareNode node) {
    return manifest
        .find(node.getName())
        .flatMap(NodeManifest.Node::component)
        .map(component -> folder + "/" + component.file())
        .orElseThrow(
            () ->
                new DiagnosticException(
                    DiagnosticException.Reason.INPUT, manifest.missing(node.getName())));
  }
}
