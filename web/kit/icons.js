// The icons of the canvas and of the windows: strokes in a square of 20 by 20, as SVG path data. A stroke of zero
// length is a dot. assets/icons/strokes.py reads this file for the canvas.

// On the canvas and in the windows.
export const shared = {
  plus: "M3.5 10H16.5M10 3.5V16.5",
  close: "M5 5L15 15M5 15L15 5",
  check: "M5 10.5L8.8 14.2L15.5 6",
  save: "M10 2.5V13M6 9L10 13L14 9M2.5 12.5V17H17.5V12.5",
};

// Only in the windows.
export const ofWindows = {
  copy: "M7.5 7.5H16.25V16.25H7.5ZM12.5 7.5V3.75H3.75V12.5H7.5",
  qr: "M3.75 3.75H8.75V8.75H3.75ZM11.25 3.75H16.25V8.75H11.25ZM3.75 11.25H8.75V16.25H3.75ZM11.25 11.25H12.5M16.25 11.25V12.5M12.5 13.75V16.25M16.25 16.25H15",
  file: "M5 3.1H11.25L15 6.9V16.9H5ZM11.25 3.1V6.9H15",
};

// Only on the canvas.
export const ofCanvas = {
  undo: "M7.5 1.5L2.5 6L7.5 10.5M2.5 6H12.5A5.5 5.5 0 0 1 12.5 17H6",
  redo: "M12.5 1.5L17.5 6L12.5 10.5M17.5 6H7.5A5.5 5.5 0 0 0 7.5 17H14",
  link: "M8.5 14.2H6A4.2 4.2 0 0 1 6 5.8H8.5M11.5 5.8H14A4.2 4.2 0 0 1 14 14.2H11.5M6.5 10H13.5",
  minus: "M3.5 10H16.5",
  fit: "M7 2H2V7M13 2H18V7M7 18H2V13M13 18H18V13",
  fold: "M7.5 4.5L13 10L7.5 15.5",
  unfold: "M12.5 4.5L7 10L12.5 15.5",
  down: "M5 7.8L10 12.8L15 7.8",
  up: "M5 12.2L10 7.2L15 12.2",
  help: "M6 6.5A4 4 0 1 1 13.06 9.07L10 11.8V13.6M10 17.5Z",
  more: "M4 10ZM10 10ZM16 10Z",
  warning: "M10 4V11.5M10 15.5Z",
  stop: "M5 10H15",
  shapes: "M2 9L7.5 2L13 9ZM12.22 9.57A4.5 4.5 0 1 1 8.57 14.78",
  open_out: "M4 16L16 4M9 3.5H16.2V11",
  folder: "M2 16V4H8L10.5 7H18V16Z",
  robot: "M4 10A6 6 0 1 1 16 10A6 6 0 1 1 4 10ZM10 7V13M7 10H13",
  table: "M2.5 4H17.5V16H2.5ZM2.5 8.5H17.5M10 4V16",
  draw: "M2.5 17.5L4 12L13.5 2.5L17.5 6.5L8 16Z",
  transform:
    "M4 4H16V16H4ZM3.1 3.1H4.9V4.9H3.1ZM15.1 3.1H16.9V4.9H15.1ZM3.1 15.1H4.9V16.9H3.1ZM15.1 15.1H16.9V16.9H15.1Z",
  compare: "M2 4H8V16H2ZM12 4H18V16H12Z",
  board: "M1.5 3H18.5V13.5H1.5ZM6.5 13.5L4.5 18.5M13.5 13.5L15.5 18.5",
  present: "M2 3.5H18V13.5H2ZM10 13.5V17M6.5 17H13.5M8.5 6.3L12.5 8.5L8.5 10.7Z",
  charts: "M3 17H17M5.5 17V11M10 17V5M14.5 17V8.5",
  book: "M10 5.5C8 4 5.5 3.5 2.5 3.5V15.5C5.5 15.5 8 16 10 17.5C12 16 14.5 15.5 17.5 15.5V3.5C14.5 3.5 12 4 10 5.5ZM10 5.5V17.5",
  about: "M2.5 10A7.5 7.5 0 1 1 17.5 10A7.5 7.5 0 1 1 2.5 10ZM10 9.2V14M10 6.3Z",
  play: "M6 3L17 10L6 17Z",
  pause: "M6.5 3.5V16.5M13.5 3.5V16.5",
  step_on: "M7 4L13 10L7 16",
  step_back: "M13 4L7 10L13 16",
  chapter_on: "M4 4L10 10L4 16M10 4L16 10L10 16",
  chapter_back: "M10 4L4 10L10 16M16 4L10 10L16 16",
  last: "M5 4L11 10L5 16M15.5 4V16",
  first: "M15 4L9 10L15 16M4.5 4V16",
};
