package dev.eventchain.catalogue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The files of a catalogue.
 *
 * @param file the catalogue itself
 * @param overlays files that change it, in this order
 */
public record CatalogueSource(Path file, List<Path> overlays) {

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
