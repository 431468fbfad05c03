package dev.eventchain.catalogue.signal;

import dev.eventchain.diagnostics.Diagnostic;
import java.util.List;
import java.util.function.Consumer;

/** A format of catalogues. */
public interface CatalogueFormat {

  /** Returns the first part of the topics of its signals: "vss", "can". */
  String prefix();

  /** Returns the suffixes of its files, with their dots. */
  List<String> suffixes();

  /**
   * Reads the signals, in the order of the files. What cannot be read is a finding, after which
   * reading continues.
   */
  List<CatalogueSignal> read(CatalogueSource source, Consumer<Diagnostic> findings);
}
