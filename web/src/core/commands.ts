/** Names that server and client share; written by `python -m barchan.studio.commands`. */

export const PROTOCOL = 6;

export type CommandName =
  /** A frame was drawn; another one may follow. */
  | "confirm"
  /** Choose the fields that frames carry beside the surface. */
  | "view"
  /** Choose how many paths of grains frames carry. */
  | "paths"
  /** Run: on and on, some steps, or up to a step. */
  | "run"
  /** Pause. */
  | "pause"
  /** Limit the steps per second; null for no limit. */
  | "limit"
  /** Start again with the same scenario and seed. */
  | "restart"
  /** Give a live parameter a new value. */
  | "set"
  /** Replace the wind. */
  | "wind"
  /** Ask for the roses of the wind. */
  | "rose"
  /** Paint with a brush. */
  | "stroke"
  /** Undo the last gesture of the brush. */
  | "undo"
  /** Repeat the gesture that was undone last. */
  | "redo"
  /** Look back at a step; null for the newest state. */
  | "look"
  /** Continue from the state that is looked at. */
  | "branch"
  /** Return to another branch. */
  | "switch"
  /** Set bookmarks, or name known ones otherwise. */
  | "bookmark"
  /** Remove a bookmark. */
  | "unbookmark"
  /** Look at a bookmark's moment, on the branch that holds it. */
  | "visit"
  /** Ask for the measures at every fixed step, and where the run rests. */
  | "measured"
  /** Ask for the section along a line over the whole run. */
  | "space_time"
  /** Compare the surface with the terrain in a file; without a path with none. */
  | "overlay"
  /** Ask what a file of the session's folder holds: heights, or a record. */
  | "inspect"
  /** Ask for the layers of the bed along a line, as it is looked at. */
  | "strata"
  /** Start a scenario, in both runs where two are compared. */
  | "create"
  /** Set the run aside; start it and another model, or value, beside. */
  | "compare"
  /** End the second run; return to the run as it was. */
  | "alone"
  /** Show those who watch the surface in the same way. */
  | "share_look"
  /** Start lost runs again, at their beginning or from the kept state. */
  | "revive"
  /** Save a run in the session's folder; of two that are compared one or both. */
  | "save"
  /** Write a run for another program, as a file for the page to fetch. */
  | "export"
  /** Write the section over time, as a file for the page to fetch. */
  | "space_time_file"
  /** Write the comparison report of two runs, as a file for the page to fetch. */
  | "report"
  /** Break off the answer to another request. */
  | "cancel"
  /** Continue a run, or two saved together, of the session's folder. */
  | "open"
  /** Go on with a run that the studio kept when it ended unexpectedly. */
  | "open_unfinished"
  /** Delete such a run. */
  | "discard_unfinished"
  /** Ask what is wrong with a scenario's text. */
  | "check"
  /** Ask for a preset's scenario. */
  | "preset"
  /** Ask for a group of a scenario with all its defaults. */
  | "variant"
  /** Ask for the names of the runs that can be opened. */
  | "saved";

export type MessageType =
  /** Versions of messages and of Barchan, names of the runs, and whether they run in lockstep. */
  | "hello"
  /** The names of the runs have changed. */
  | "runs"
  /** Two runs that are compared started or stopped. */
  | "lockstep"
  /** What a run consists of: scenario, lattice, fields, measures, branches. */
  | "scenario"
  /** A run has begun, or its start was refused; only for the server. */
  | "begun"
  /** Kernels are being compiled, and how many functions of theirs have been. */
  | "compiling"
  /** A run has done the steps that it was asked for. */
  | "arrived"
  /** How many browsers watch; only for the one that commands. */
  | "watchers"
  /** How the browser that commands shows the surface; only for those that watch. */
  | "look"
  /** The process of a run has ended by itself; the newest step that all runs can continue from. */
  | "lost"
  /** How far the answer to a request is. */
  | "progress"
  /** The answer to a request. */
  | "done"
  /** A request that cannot be carried out, and why. */
  | "refused";
