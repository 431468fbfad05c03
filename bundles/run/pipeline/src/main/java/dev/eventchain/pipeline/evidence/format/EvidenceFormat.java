package dev.eventchain.pipeline.evidence.format;

import dev.eventchain.pipeline.evidence.Evidence;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * A format in which tools of requirements read the evidence of a run. Equal evidence gives equal
 * bytes; nothing in it says when it was written.
 */
public enum EvidenceFormat {
  /** JUnit XML with a case for each file of tests, and nothing else. */
  EVIDENCE {
    @Override
    public Map<String, byte[]> render(Evidence evidence, Path target) {
      return one(EvidenceJunit.render(evidence));
    }
  },
  /** A folder with files of LOBSTER, and its configuration. */
  LOBSTER {
    @Override
    public Map<String, byte[]> render(Evidence evidence, Path target) {
      return LobsterFiles.render(evidence);
    }

    @Override
    public List<String> files(Path target) {
      return LobsterFiles.NAMES;
    }
  },
  /** The file {@code needs.json} of sphinx-needs. */
  NEEDS {
    @Override
    public Map<String, byte[]> render(Evidence evidence, Path target) {
      return one(NeedsJson.render(evidence));
    }
  },
  /** A ReqIF document with a verdict on each requirement. */
  REQIF {
    @Override
    public Map<String, byte[]> render(Evidence evidence, Path target) throws IOException {
      return Map.of("", ReqifSource.of(evidence).withVerdicts(evidence));
    }
  },
  /** A table of requirements and their evidence: CSV, or a page if the file is named so. */
  MATRIX {
    @Override
    public Map<String, byte[]> render(Evidence evidence, Path target) {
      return isPage(target)
          ? one(MatrixPage.render(evidence))
          : Map.of("", MatrixTable.render(evidence));
    }

    @Override
    public boolean fits(Path target) {
      return isPage(target) || lowerCase(target).endsWith(".csv");
    }

    @Override
    public String needed() {
      return "a file whose name ends with .csv or .html";
    }

    private static boolean isPage(Path target) {
      return lowerCase(target).endsWith(".html");
    }
  };

  /**
   * Returns the files and their contents.
   *
   * @param target where the report goes
   * @return by name relative to the target; empty for the target itself
   * @throws IOException if the report needs a file of the project that cannot be used
   */
  public abstract Map<String, byte[]> render(Evidence evidence, Path target) throws IOException;

  /** Returns the names of the files, relative to the target; empty for the target itself. */
  public List<String> files(Path target) {
    return List.of("");
  }

  /** Returns whether a report in this format may go there. */
  public boolean fits(Path target) {
    return true;
  }

  /** Returns what a report in this format needs to be, for people. */
  public String needed() {
    return "a file";
  }

  private static String lowerCase(Path target) {
    return target.toString().toLowerCase(Locale.ROOT);
  }

  private static Map<String, byte[]> one(String content) {
    return Map.of("", content.getBytes(StandardCharsets.UTF_8));
  }

  /** Returns the name on the command line. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
