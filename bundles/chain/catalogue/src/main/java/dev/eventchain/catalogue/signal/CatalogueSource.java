package dev.eventchain.catalogue.signal;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The files of a catalogue.
 *
 * @param file the catalogue itself
 * @param overlays files that change it, in this order
 * @param node the participant of a network as which the software sends and receives; empty if it
 *     only receives
 */
public record CatalogueSource(Path file, List<Path> overlays, Optional<String> node) {

  /** Copies the list. */
  public CatalogueSource {
    overlays = List.copyOf(overlays);
  }

  /** Returns all files, without those that they include. */
  public List<Path> files() {
    List<Path> files = new ArrayList<>(List.of(file));
    files.addAll(overlays);
    return files;
  }
}
