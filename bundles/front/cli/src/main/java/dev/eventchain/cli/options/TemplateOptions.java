package dev.eventchain.cli.options;

import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Option;

/** Options for what templates outside of projects need besides their own files. */
public final class TemplateOptions {

  @Option(
      names = "--services",
      paramLabel = "JAR|FOLDER",
      description = "Java classes that a template may call with invoke(...); may be repeated.")
  private List<Path> services = List.of();

  @Option(
      names = "--source",
      paramLabel = "FOLDER",
      description =
          "A source root of a template: [import a::b] is a/b.mtl below it; may be repeated."
              + " A template's own root is found if the template is in folder a.")
  private List<Path> sources = List.of();

  /** Returns the classes that a template may call. */
  public List<Path> services() {
    return services;
  }

  /** Returns the source roots. */
  public List<Path> sources() {
    return sources;
  }
}
