package dev.eventchain.output;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;

/** Findings of an output folder about its files. */
final class OutputFindings {

  private final OutputStorage storage;

  OutputFindings(OutputStorage storage) {
    this.storage = storage;
  }

  /**
   * Returns the warning about an existing file that was kept.
   *
   * @param known true if an earlier run wrote a file of this name
   */
  Diagnostic kept(String path, boolean known) {
    String what =
        known
            ? "differs from what was written, and was kept."
            : "is not recorded as written by a run, and was kept.";
    return edited(path, what)
        .withHint(
            "Replace it with --overwrite, which keeps the content of protected areas; deleting it"
                + " does not.");
  }

  Diagnostic overwritten(String path) {
    return edited(path, "differed from what was written, and was replaced.");
  }

  Diagnostic removed(String path) {
    return edited(path, "differed from what was written, and was removed.");
  }

  Diagnostic abandoned(String path) {
    return edited(path, "is no longer produced but may contain changes made by hand, and was kept.")
        .withHint("Delete the file if it is not needed.");
  }

  private Diagnostic edited(String path, String what) {
    return Diagnostic.of(
        OutputRules.EVENTCHAIN_FILE_EDITED,
        "The file '" + path + "' " + what,
        SourceLocation.of(storage.shown(path)));
  }

  /** Returns {@link OutputPath#refusal}, located at the output folder. */
  Diagnostic refusedHere(String name, OutputPath path) {
    return path.refusal(name).withLocation(SourceLocation.of(storage.shown("")));
  }

  Diagnostic linkRefused(String name, IOException e) {
    return Diagnostic.of(
            OutputRules.OUTPUT_PATH_REFUSED,
            "The file '" + OutputPath.shown(name) + "' was not written: " + e.getMessage() + ".",
            SourceLocation.of(storage.shown(name)))
        .withHint("Replace the link with a folder.");
  }

  static DiagnosticException unwritable(String place, IOException e) {
    return failure(
        Diagnostic.of(
                OutputRules.OUTPUT_UNWRITABLE,
                "The output cannot be written: " + SourceText.reason(e) + ".",
                SourceLocation.of(place.replace('\\', '/')))
            .withHint("Check permissions and free space, or choose another folder with -o."));
  }

  static DiagnosticException failure(Diagnostic diagnostic) {
    return new DiagnosticException(DiagnosticException.Reason.INPUT, diagnostic);
  }

  Diagnostic damaged() {
    return Diagnostic.of(
            OutputRules.OUTPUT_RECORDS_DAMAGED,
            "The records of the files written earlier cannot be read.",
            SourceLocation.of(storage.shown(OutputPath.RESERVED + "/files.json")))
        .withHint(
            "Files that differ count as edited by hand; delete them to have them"
                + " written again.");
  }
}
