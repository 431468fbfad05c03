package dev.eventchain.project;

import dev.eventchain.description.SoftwareBaseNames;

/**
 * Names of the files and folders in a user's project, relative to its folder, and of those results
 * that editors and agents read. Names of other results are those of the stages that write them.
 */
public final class ProjectLayout {

  /** The configuration; a folder with it is a project. */
  public static final String CONFIGURATION = "eventchain.yaml";

  /** The suppressed findings. */
  public static final String SUPPRESSIONS = "eventchain-suppressions.yaml";

  /** The accepted texts of requirements. */
  public static final String ACCEPTED = "accepted.yaml";

  /** The accepted mutants. */
  public static final String MUTANTS = "mutants.yaml";

  /** The functional requirements in Markdown. */
  public static final String REQUIREMENTS = "requirements.md";

  /** The non-functional requirements. */
  public static final String DESIGN_RULES = "design-rules.md";

  /** The constraints that people write. */
  public static final String CONSTRAINTS = "constraints.ocl";

  /** The chain that people edit. */
  public static final String MODEL = "model/chain.xmi";

  /** The existing software. */
  public static final String SOFTWARE_BASE = "software-base";

  /** The descriptions of existing components. */
  public static final String COMPONENTS = SOFTWARE_BASE + "/" + SoftwareBaseNames.COMPONENTS;

  /** The signals of the vehicle. */
  public static final String SIGNALS = SOFTWARE_BASE + "/" + SoftwareBaseNames.SIGNALS;

  /** The open questions about the existing software. */
  public static final String QUESTIONS = SOFTWARE_BASE + "/" + SoftwareBaseNames.QUESTIONS;

  /** The message definitions, {@code <package>/msg/*.msg}. */
  public static final String MESSAGES = SOFTWARE_BASE + "/" + SoftwareBaseNames.MESSAGES;

  /** The connections between world and chain. */
  public static final String BENCH = "bench.yaml";

  /** The scenarios. */
  public static final String SCENARIOS = "scenarios";

  /** The faults that are simulated in scenarios. */
  public static final String FAULTS = "faults.yaml";

  /** The tests of components. */
  public static final String TESTS = "tests";

  /** The recorded answers of language models. */
  public static final String RECORDINGS = "recordings";

  /** The results, unless another folder is named. */
  public static final String OUTPUT = "out";

  /** The verdict, among the results of a run. */
  public static final String VERDICT = "verdict.json";

  /** The outcomes of mutants, among the results. */
  public static final String MUTANT_RESULTS = "mutants.json";

  private ProjectLayout() {}
}
