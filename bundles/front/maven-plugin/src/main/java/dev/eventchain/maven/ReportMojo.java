package dev.eventchain.maven;

import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.run.Stage;
import org.apache.maven.plugins.annotations.LifecyclePhase;
import org.apache.maven.plugins.annotations.Mojo;

/**
 * Does the same as {@code simulate}, unless up to date, and writes the report {@code report.html},
 * even for a verdict that fails the build.
 */
@Mojo(name = "report", defaultPhase = LifecyclePhase.POST_INTEGRATION_TEST)
public final class ReportMojo extends SimulateMojo {

  @Override
  Outcome work() {
    return simulate(Stage.REPORT);
  }
}
