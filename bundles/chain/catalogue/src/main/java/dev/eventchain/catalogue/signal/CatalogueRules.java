package dev.eventchain.catalogue.signal;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import java.nio.file.Path;

/** Rules of the findings about catalogues of signals. */
public final class CatalogueRules {

  public static final Rule ATTRIBUTE = Rule.warning("catalogue.attribute");
  public static final Rule EMPTY = Rule.error("catalogue.empty");
  public static final Rule ENTRY = Rule.error("catalogue.entry");
  public static final Rule FORMAT = Rule.error("catalogue.format");
  public static final Rule INCLUDE = Rule.error("catalogue.include");
  public static final Rule NODE = Rule.error("catalogue.node");
  public static final Rule OVERLAP = Rule.warning("catalogue.overlap");
  public static final Rule OVERLAY = Rule.error("catalogue.overlay");
  public static final Rule RANGE = Rule.warning("catalogue.range");
  public static final Rule REFERENCE = Rule.error("catalogue.reference");
  public static final Rule SIZE = Rule.error("catalogue.size");
  public static final Rule UNREAD = Rule.warning("catalogue.unread");

  private CatalogueRules() {}

  /** Returns a finding about overlays of a format that has none. */
  public static Diagnostic noOverlays(Path overlay, String format, String hint) {
    return Diagnostic.of(
            OVERLAY, "A catalogue in " + format + " takes no overlays.", SourceLocation.of(overlay))
        .withHint(hint);
  }

  /** Returns a finding about the node of a format that has none. */
  public static Diagnostic noNode(CatalogueSource source, String format) {
    return Diagnostic.of(
            NODE,
            format + " has no nodes, so there is no '" + source.node().orElse("") + "'.",
            SourceLocation.of(source.file()))
        .withHint("Leave `node` out; only a network in DBC or ARXML has nodes.");
  }
}
