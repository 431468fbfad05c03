/**
 * The stages from requirements to verdict as a Java API. It writes files below an output folder and
 * nothing else: it never prints and never ends the process.
 */
package dev.eventchain.pipeline;
