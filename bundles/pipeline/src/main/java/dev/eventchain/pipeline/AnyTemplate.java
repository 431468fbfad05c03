package dev.eventchain.pipeline;

import java.nio.file.Path;
import java.util.List;

/**
 * A template that stands in no project, and what it needs.
 *
 * @param main the main module
 * @param sources the source roots of its modules; folders that it is in need not be named
 * @param services JARs and folders of classes whose methods the templates may call
 * @param properties files of properties; where several have a key, the first one counts
 */
public record AnyTemplate(
    Path main, List<Path> sources, List<Path> services, List<Path> properties) {

  /** Keeps the lists from changing. */
  public AnyTemplate {
    sources = List.copyOf(sources);
    services = List.copyOf(services);
    properties = List.copyOf(properties);
  }
}
