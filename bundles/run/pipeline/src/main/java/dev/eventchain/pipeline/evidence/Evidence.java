package dev.eventchain.pipeline.evidence;

import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * Statements of a run about the requirements of a project. What was not tested is neither passed
 * nor failed, and supports no requirement.
 *
 * @param name the name of the project
 * @param title its title
 * @param summary the verdict of the run, in a sentence
 * @param requirements in the order of their file
 * @param components in the order of the chain
 * @param tests component tests, then scenarios
 */
public record Evidence(
    String name,
    String title,
    String summary,
    List<Requirement> requirements,
    List<Component> components,
    List<Test> tests) {

  /** Copies the lists. */
  public Evidence {
    requirements = List.copyOf(requirements);
    components = List.copyOf(components);
    tests = List.copyOf(tests);
  }

  /** Verdict about a requirement. */
  public enum Verdict {
    PROVED,
    VIOLATED,
    NOT_TESTED;

    /** Returns the verdict for people. */
    public String words() {
      return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
  }

  /** End of a test. */
  public enum Result {
    PASSED,
    FAILED,
    NOT_TESTED;

    /** Returns the result for people. */
    public String words() {
      return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
  }

  /**
   * A requirement.
   *
   * @param place where it is written
   * @param reason why it is not tested, in words without a full stop; empty if it is
   * @param strength empty if it was not measured
   */
  public record Requirement(
      String id,
      String text,
      SourceLocation place,
      Verdict verdict,
      Optional<String> reason,
      Optional<Strength> strength) {

    /** Returns the verdict for people, with the reason if it is not tested. */
    public String words() {
      return reason.map(it -> verdict.words() + ": " + it).orElse(verdict.words());
    }

    /**
     * Returns whether nothing remains to be shown, as far as that is measured: it is proved, all
     * standard faults of its components were driven, and its criteria notice each of them.
     */
    public boolean isFullyVerified() {
      return verdict == Verdict.PROVED && strength.filter(Strength::isWhole).isPresent();
    }
  }

  /**
   * The standard faults of its components that the criteria of a requirement notice.
   *
   * @param faults the number of all that were driven and changed something
   * @param sampleOf the number of all that may change something, if not all were driven
   */
  public record Strength(int noticed, int faults, OptionalLong sampleOf) {

    boolean isWhole() {
      return faults > 0 && noticed == faults && sampleOf.isEmpty();
    }

    /** Returns it for people: "notices 9 of 11 faults, a sample of 40". */
    public String words() {
      String words = String.format(Locale.ROOT, "notices %d of %d faults", noticed, faults);
      return sampleOf.isPresent() ? words + ", a sample of " + sampleOf.getAsLong() : words;
    }
  }

  /**
   * A component of the chain.
   *
   * @param place its file
   * @param satisfies the requirements that it is said to satisfy
   */
  public record Component(String name, SourceLocation place, List<String> satisfies) {

    /** Copies the list. */
    public Component {
      satisfies = List.copyOf(satisfies);
    }
  }

  /**
   * A scenario, or a test of a component.
   *
   * @param name unique among the scenarios, or among the tests of its component
   * @param component the tested component; empty for a scenario
   * @param place where it is written
   * @param text what was measured or is missing, in words
   * @param seconds the simulated time
   * @param about its result for each requirement that it names and judges
   */
  public record Test(
      String name,
      Optional<String> component,
      SourceLocation place,
      Result result,
      String text,
      double seconds,
      List<About> about) {

    /** Copies the list. */
    public Test {
      about = List.copyOf(about);
    }

    /** Returns a name that is unique among all tests of its kind. */
    public String fullName() {
      return component.map(it -> it + ": " + name).orElse(name);
    }

    /** Returns what it says about a requirement; empty if nothing. */
    public Optional<Result> about(String requirement) {
      return about.stream()
          .filter(each -> each.requirement().equals(requirement))
          .map(About::result)
          .findFirst();
    }
  }

  /** Statement of a test about a requirement. */
  public record About(String requirement, Result result) {}

  /** Returns the requirement with this id. */
  public Optional<Requirement> requirement(String id) {
    return requirements.stream().filter(each -> each.id().equals(id)).findFirst();
  }

  /**
   * Returns the requirements for which the result of a test holds. A test that passed holds for
   * those that are proved: readers take a link to a passed test for a verification, also where
   * something else violates the requirement or keeps it from being judged. They are in the order of
   * all requirements.
   */
  public List<String> supportedBy(Test test) {
    return requirements.stream()
        .filter(each -> test.about(each.id()).filter(test.result()::equals).isPresent())
        .filter(each -> test.result() != Result.PASSED || each.verdict() == Verdict.PROVED)
        .map(Requirement::id)
        .toList();
  }

  /** Returns the components that are said to satisfy a requirement. */
  public List<Component> componentsOf(String requirement) {
    return components.stream().filter(each -> each.satisfies().contains(requirement)).toList();
  }
}
