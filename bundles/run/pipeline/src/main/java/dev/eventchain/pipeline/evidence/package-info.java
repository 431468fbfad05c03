/** What a run says about each requirement: its components, tests and scenarios, and a verdict. */
package dev.eventchain.pipeline.evidence;
