package dev.eventchain.pipeline.campaign;

import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.simulation.verdict.CaseResult;
import java.util.Locale;

/** Tells how many cases are done, how many of them failed, and about how long the others take. */
final class CampaignProgress {

  private final Progress progress;
  private final int known;
  private final int open;
  private final long start = System.nanoTime();
  private int done;
  private int failed;

  /**
   * Creates the progress of cases.
   *
   * @param known the number of cases that were known before
   * @param open the number of the others; a boundary may add some
   */
  CampaignProgress(Progress progress, int known, int open) {
    this.progress = progress;
    this.known = known;
    this.open = open;
  }

  void done(CaseResult result) {
    done++;
    failed += result.label() == CaseResult.Label.PASSED ? 0 : 1;
    int all = Math.max(open, done);
    double left = (System.nanoTime() - start) / 1e9 / done * (all - done);
    progress.step(
        Stage.SIMULATE,
        String.format(
            Locale.ROOT,
            "case %d of %d, %d not passed, %s left",
            known + done,
            known + all,
            failed,
            words(left)));
  }

  /** Returns a time in words: 8 s, 12 min, 3.5 h. */
  static String words(double seconds) {
    if (seconds < 90) {
      return Math.round(seconds) + " s";
    }
    return seconds < 5400
        ? Math.round(seconds / 60) + " min"
        : String.format(Locale.ROOT, "%.1f h", seconds / 3600);
  }
}
