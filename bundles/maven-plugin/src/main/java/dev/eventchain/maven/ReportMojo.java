package dev.eventchain.maven;

import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.Stage;
import org.apache.maven.plugins.annotations.LifecyclePhase;
import org.apache.maven.plugins.annotations.Mojo;

/**
 * Does what {@code simulate} does, as far as it is not done yet, and writes the page about it,
 * {@code report.html}; of a verdict that fails the build, too.
 */
@Mojo(name = "report", defaultPhase = LifecyclePhase.POST_INTEGRATION_TEST)
public final class ReportMojo extends SimulateMojo {

  @Override
  Outcome work() {
    return simulate(Stage.REPORT);
  }
}
