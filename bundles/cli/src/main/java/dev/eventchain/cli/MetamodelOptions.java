package dev.eventchain.cli;

import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Option;

/** What the models are instances of that stand in no project. */
final class MetamodelOptions {

  @Option(
      names = "--metamodel",
      paramLabel = "FILE",
      description = "An Ecore metamodel of the models (default: event chains); may be repeated.")
  List<Path> metamodels = List.of();
}
